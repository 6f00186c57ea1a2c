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

/// What one call of fill() asks for, shared by all of its tiles. All that it refers to outlives it.
template <std::floating_point T>
struct FillTask {
  const SignedDistanceFunction<T>& solid;
  const GridPatch<T>& gridPatch;
  const FillTargets<T>& targets;
  T limit;          ///< values beyond it become +-limit; may be infinite
  TileOrder order;  ///< of the indices in each tile
  Guarantee<T> promise = solid.guarantee();

  [[nodiscard]] bool hasBand() const { return limit < std::numeric_limits<T>::infinity(); }
};

}  // namespace cutwater::detail
