#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>

namespace cutwater {

namespace {

/// Small enough that a batch's scratch memory fits the L1 cache.
constexpr std::size_t kBatch = 256;

template <typename Value>
void checkLength(const char* message, std::span<Value> array, std::size_t cells) {
  require(array.empty() || array.size() == cells, message, Named{"values", array.size()},
          Named{"cells", cells});
}

/// Fills the values of a batch of cells from `first` on.
template <std::floating_point T>
void fillBatch(const SignedDistanceFunction<T>& solid, std::span<const Vec3<T>> centers,
               const OctreeTargets<T>& targets, std::size_t first) {
  if (targets.normal.empty() && targets.patch.empty()) {
    solid.signedDistances(centers, targets.distance.subspan(first, centers.size()), {.threads = 1});
    return;
  }
  Scratch<SurfacePoint<T>, kBatch> scratch;
  const auto hits = scratch.first(centers.size());
  solid.closestPoints(centers, hits, {.threads = 1});
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!targets.distance.empty()) targets.distance[first + i] = hits[i].distance;
    if (!targets.normal.empty()) targets.normal[first + i] = hits[i].normal;
    if (!targets.patch.empty()) targets.patch[first + i] = hits[i].owner.patch;
  }
}

}  // namespace

template <std::floating_point T>
void OctreeTargets<T>::check(std::size_t cells) const {
  checkLength("OctreeTargets: need one distance per cell", distance, cells);
  checkLength("OctreeTargets: need one normal per cell", normal, cells);
  checkLength("OctreeTargets: need one patch per cell", patch, cells);
}

template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
          const OctreeTargets<T>& targets, const OctreeFillOptions& options) {
  const auto cells = mesh.cells();
  targets.check(cells.size());
  require(options.threads >= 0, "fill: need threads >= 0", Named{"threads", options.threads});
  if (targets.isEmpty()) return;
  detail::parallelBatches(
      cells.size(), kBatch,
      {.threads = options.threads, .grain = 4 * kBatch, .progress = options.progress},
      [&](std::size_t first, std::size_t count) {
        Scratch<Vec3<T>, kBatch> scratch;
        const auto centers = scratch.first(count);
        for (std::size_t i = 0; i < count; ++i) centers[i] = mesh.center(cells[first + i]);
        fillBatch<T>(solid, centers, targets, first);
      });
}

template struct OctreeTargets<float>;
template struct OctreeTargets<double>;
template void fill(const SignedDistanceFunction<float>&, const OctreeCells<float>&,
                   const OctreeTargets<float>&, const OctreeFillOptions&);
template void fill(const SignedDistanceFunction<double>&, const OctreeCells<double>&,
                   const OctreeTargets<double>&, const OctreeFillOptions&);

}  // namespace cutwater
