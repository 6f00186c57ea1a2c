#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cutwater {

/// XXH64 of the bytes, as Collet 2012 specifies it ("xxHash fast digest algorithm", with seed 0):
/// what `xxhsum -H64` tells of a file. It finds accidents, not forgeries: a change goes unnoticed
/// with a probability of 2^-64. About 10 GB/s on one core.
[[nodiscard]] std::uint64_t xxHash64(std::span<const std::byte> bytes);

/// The same purpose for much data, shared by at most so many threads (see ParallelOptions): the
/// XXH64 of the XXH64 of every 2^20 bytes, each as eight bytes in the machine's order. The value
/// does not depend on the threads.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes, int threads = 0);

}  // namespace cutwater
