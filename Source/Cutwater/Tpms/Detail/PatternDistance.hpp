#pragma once

#include <Cutwater/Tpms/Detail/LevelDistances.hpp>

namespace cutwater::detail {

/// The distance to the surface F = 0 of a pattern. All lengths are in radians.
///
/// Newton's method finds a point q of the surface. With g the slope of F at q, and q the foot of
/// the point x at the distance d, F on the ball about x through q is at least
/// (g / d - H) |y - q|^2 / 2: if g >= H d, the ball is free of surface, and d is the distance up to
/// rounding. Otherwise the same argument with the second derivatives at q, which the third ones
/// change by no more than T |y - q|, frees a ball about q. Cubes cover the rest of the ball about
/// x, and are halved until they are free, by CubeInBall, or farther away than d minus the
/// tolerance.
class PatternDistance {
 public:
  /// Distances are certain to within the tolerance.
  PatternDistance(TpmsPattern pattern, double tolerance);

  /// The distance from a point, in radians, if it is less than `reach`; otherwise a number that is
  /// at least `reach` and at most the distance.
  [[nodiscard]] double upTo(double reach, const Vec3<double>& point) const;

  /// Up to this reach, distances are certain to within rounding.
  [[nodiscard]] static double certainReach(const TpmsPattern& pattern) {
    return 0.97 * pattern.leastSlope() / pattern.curvature();
  }

 private:
  friend class SurfaceSearch;

  [[nodiscard]] double lowerBound(const Vec3<double>& point) const;

  TpmsPattern pattern_;
  LevelTerms<double> terms_;
  double tolerance_;
};

}  // namespace cutwater::detail
