#pragma once

#include <Cutwater/Tpms/Detail/PatternExpansion.hpp>

namespace cutwater::detail {

/// The part of a ball that lies in a cube. Lengths are in radians.
struct CubeInBall {
  Vec3<double> center;  ///< of the cube, from that of the ball
  double half;          ///< of the cube's sides
  double radius;        ///< of the ball
};

/// Whether F > 0 (for side 1) or F < 0 (for side -1) is certain in all of this part; f is F
/// expanded about the centre of the cube, c.
///
/// Let corners be at the distance a from c, v = y - c, and r the ball's radius about x = c - w. In
/// the ball, r^2 - |y - x|^2 >= 0, so any multiple m >= 0 of it may be subtracted from F (the
/// S-procedure: Boyd and Vandenberghe 2004, "Convex Optimization", appendix B). With the value,
/// gradient and second derivatives A of F at c, and a bound T of the third derivatives, the rest is
/// at least
///
///     F - m (r^2 - |w|^2) - T a^3 / 6 + (grad F + 2 m w) v + v (A + 2 m) v / 2
///
/// where m is 0, or the value that leaves no slope along w. As the latter makes up for the sphere's
/// curvature, large cubes are free even where the sphere touches the surface; only third
/// derivatives limit their size.
[[nodiscard]] bool isOnOneSide(const CubeInBall& part, const TpmsPattern& pattern,
                               const PatternExpansion& f, double side);

}  // namespace cutwater::detail
