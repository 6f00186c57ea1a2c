#pragma once

#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>
#include <Cutwater/Grid/Fill.hpp>

namespace cutwater::detail {

/// Whether some target takes the closest surface point of a position.
template <std::floating_point T>
[[nodiscard]] bool takesSurfacePoints(const FillTargets<T>& targets) {
  return targets.patch.data != nullptr || targets.closestPoint.data != nullptr ||
         targets.normal.data != nullptr;
}
/// Whether some target takes what is found at a position.
template <std::floating_point T>
[[nodiscard]] bool takesPoints(const FillTargets<T>& targets) {
  return targets.distance.data != nullptr || takesSurfacePoints(targets);
}

/// The largest sizes of coordinates.
template <std::floating_point T>
[[nodiscard]] Vec3<T> farthestPosition(const GridPatch<T>& gridPatch) {
  const auto& [level, indices] = gridPatch;
  return max(abs(level.position(indices.lo)), abs(level.position(indices.hi)));
}

/// What one call of fill() asks for, shared by all of its tiles. All that it refers to outlives it.
template <std::floating_point T>
struct FillTask {
  const SignedDistanceFunction<T>& solid;
  const GridPatch<T>& gridPatch;
  const FillTargets<T>& targets;
  T limit;          ///< values beyond it become +-limit; may be infinite
  TileOrder order;  ///< of the indices in each tile
  Guarantee<T> promise = solid.guarantee();
  /// Bounds the rounding of values at all positions.
  T rounding = promise.error(length(farthestPosition(gridPatch)));
  /// Whether the solid finds the points within the limit in its own way, and neighbours are no
  /// farther than the limit: where values are 1-Lipschitz, they tell those beyond it.
  bool hasOwnWay = hasBand() && maxComponent(gridPatch.level.spacing()) <= limit &&
                   solid.signedDistancesWithin({}, limit, {});

  [[nodiscard]] bool hasBand() const { return limit < std::numeric_limits<T>::infinity(); }
  /// Whether it has, and the surface is as far away as values say.
  [[nodiscard]] bool hasExactWay() const {
    return hasOwnWay && promise.lipschitz && promise.outside == Quality::Exact &&
           promise.inside == Quality::Exact;
  }
};

}  // namespace cutwater::detail
