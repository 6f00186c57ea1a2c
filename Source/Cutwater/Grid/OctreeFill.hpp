#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

namespace cutwater {

/// The arrays that one pass over an octree mesh fills, one value per cell in the order of cells();
/// empty ones are skipped.
template <std::floating_point T>
struct OctreeTargets {
  std::span<T> distance = {};  ///< signedDistance() at the centre, to the bit
  /// Unit normal, out of the solid, and patch (see patchNames()) of the surface point closest to
  /// the centre.
  std::span<Vec3<T>> normal = {};
  std::span<std::uint32_t> patch = {};

  /// Whether all arrays are empty.
  [[nodiscard]] bool isEmpty() const { return distance.empty() && normal.empty() && patch.empty(); }
  /// @throws Error if an array is neither empty nor of `cells` values.
  void check(std::size_t cells) const;
};

/// Options of fill() on a mesh.
struct OctreeFillOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Evaluates the solid at the centre of every cell, in batches of neighbours; each value has the
/// bits of closestPoint() there. Serial inside an active parallel region.
/// @throws Error if an array is neither empty nor as long as cells(), or `threads` is negative.
template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
          const OctreeTargets<T>& targets, const OctreeFillOptions& options = {});

extern template struct OctreeTargets<float>;
extern template struct OctreeTargets<double>;
extern template void fill(const SignedDistanceFunction<float>&, const OctreeCells<float>&,
                          const OctreeTargets<float>&, const OctreeFillOptions&);
extern template void fill(const SignedDistanceFunction<double>&, const OctreeCells<double>&,
                          const OctreeTargets<double>&, const OctreeFillOptions&);

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
