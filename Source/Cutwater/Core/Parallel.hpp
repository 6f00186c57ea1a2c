#pragma once

#include <Cutwater/Core/FunctionRef.hpp>

#include <cstddef>
#include <functional>

namespace cutwater {

/// Told the fraction done, from 0 to 1, now and then, by the thread that started the work only.
using Progress = std::function<void(double fraction)>;

/// Options of whatever runs in parallel. No answer depends on them.
struct ParallelOptions {
  /// At most this many threads; 0: as many as OpenMP would use. Always 1 inside an active parallel
  /// region and in a library built without OpenMP.
  int threads = 0;
  /// Work is handed out in ranges of this many items.
  std::size_t grain = 1;
  Progress progress = {};
};

/// Calls body(begin, end) for ranges that together cover [0, count), in parallel.
///
/// The first exception thrown by `body` ends the hand-out of work and is rethrown here, outside of
/// the parallel region. OpenMP's global settings are left alone.
void parallelFor(std::size_t count, const ParallelOptions& options,
                 FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// The number of threads parallelFor() would use for plenty of work.
[[nodiscard]] int availableThreads();

}  // namespace cutwater
