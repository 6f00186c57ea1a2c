#pragma once

#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Grid/PatchBlocks.hpp>

namespace cutwater::detail {

/// What one call of fill() is about, for all of its tiles. Everything that is referred to outlives
/// it.
template <std::floating_point T>
struct FillTask {
  const SignedDistanceFunction<T>& solid;
  const Patch<T>& patch;
  const FillTargets<T>& targets;
  T limit;  ///< values beyond become +-limit; may be infinite
  TileOrder order;
  Guarantee<T> promise = solid.guarantee();

  [[nodiscard]] bool hasBand() const { return limit < std::numeric_limits<T>::infinity(); }
};

}  // namespace cutwater::detail
