#pragma once

#include <Cutwater/Surface/Detail/HoleCaps.hpp>

#include <vector>

namespace cutwater {

/// Caps that are looked at together, by the indices of their triangles.
struct CapGroup {
  std::vector<std::uint32_t> triangles;
  /// All lie in one plane, with rims that nowhere meet, so that no part of the plane is covered
  /// more than once, whichever way: no point sees more than half of the full solid angle.
  bool isFlat = false;
};

/// The flat caps, a group for each plane, and one group of all others, if there are any. Of the
/// coordinates, the largest is about 1: a cap is flat within kFlatness of that, as much as single
/// precision rounds, and within kFlatnessOfCap of its own size.
[[nodiscard]] std::vector<CapGroup> capsByPlane(const HoleCaps& caps);

inline constexpr double kFlatness = 0x1p-22;
inline constexpr double kFlatnessOfCap = 0x1p-13;

}  // namespace cutwater
