#pragma once

#include <Cutwater/Tpms/TpmsPattern.hpp>

#include <optional>

namespace cutwater::detail {

/// A point of the surface F = 0 of a pattern where the line to another point, x, is normal to it.
/// Lengths are in radians.
struct FootPoint {
  Vec3<double> place;
  double distance;  ///< to x
  /// Within the ball of this radius about it, no surface is nearer to x. More than twice the
  /// distance: it is the nearest point of the surface.
  double freeRadius;
};

/// One that Newton's method leads to from a start; none if that leads nowhere.
[[nodiscard]] std::optional<FootPoint> footPoint(const TpmsPattern& pattern, const Vec3<double>& x,
                                                 const Vec3<double>& start);

}  // namespace cutwater::detail
