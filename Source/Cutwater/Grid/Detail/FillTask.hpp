#pragma once

#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Grid/Detail/PatchBlocks.hpp>
#include <Cutwater/Grid/Fill.hpp>

namespace cutwater::detail {

/// The arguments of one call of fill(), shared by all of its tiles. Everything it refers to
/// outlives it.
template <std::floating_point T>
struct FillTask {
  const SignedDistanceFunction<T>& solid;
  const GridPatch<T>& patch;
  const FillTargets<T>& targets;
  T limit;  ///< values beyond it become +-limit; may be infinite
  TileOrder order;
  Guarantee<T> promise = solid.guarantee();

  [[nodiscard]] bool hasBand() const { return limit < std::numeric_limits<T>::infinity(); }
};

}  // namespace cutwater::detail
