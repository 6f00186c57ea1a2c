#pragma once

namespace cutwater::benchmarks {

/// How many times the work of one thread so many threads do in the same time: what the machine
/// really gives, with nothing to share but its cores.
[[nodiscard]] double coresSeen(int threads);

}  // namespace cutwater::benchmarks
