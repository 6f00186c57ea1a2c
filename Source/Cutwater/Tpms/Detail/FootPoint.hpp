#pragma once

#include <Cutwater/Tpms/TpmsPattern.hpp>

#include <optional>

namespace cutwater::detail {

/// A point of the surface F = 0 of a pattern where the line to another point, x, is normal to the
/// surface. Lengths are in radians.
struct FootPoint {
  Vec3<double> place;
  double distance;  ///< to x
  /// Within the ball of this radius about the foot point, no surface is nearer to x. If it is more
  /// than twice the distance, the foot point is the nearest point of the surface.
  double freeRadius;
};

/// The foot point that Newton's method finds from a start; none if it finds none.
[[nodiscard]] std::optional<FootPoint> footPoint(const TpmsPattern& pattern, const Vec3<double>& x,
                                                 const Vec3<double>& start);

}  // namespace cutwater::detail
