#pragma once

#include <Cutwater/Grid/OctreeFill.hpp>

namespace cutwater {

/// Checksum of a mesh and of values in its cells: the sum, modulo 2^64, of each cell's XXH64 (see
/// Checksum.hpp) over its level, index and kind and the bits of its values. It depends neither on
/// the order of the cells nor on the threads, and the checksums of parts add up to that of the
/// whole: the same mesh has the same sum however many ranks share it. There is one value per cell,
/// as in fill(); empty arrays are skipped.
/// @throws Error as fill().
template <std::floating_point T>
[[nodiscard]] std::uint64_t checksum(const OctreeCells<T>& mesh, const OctreeTargets<T>& values,
                                     int threads = 0);

extern template std::uint64_t checksum(const OctreeCells<float>&, const OctreeTargets<float>&, int);
extern template std::uint64_t checksum(const OctreeCells<double>&, const OctreeTargets<double>&,
                                       int);

}  // namespace cutwater
