#pragma once

#include <Cutwater/Tpms/PatternExpansion.hpp>

namespace cutwater::detail {

/// The part of a ball that lies in a cube. Lengths are in radians.
struct CubeInBall {
  Vec3<double> center;  ///< of the cube, from that of the ball
  double half;          ///< of the cube's sides
  double radius;        ///< of the ball
};

/// Whether F > 0, or F < 0 for the side -1, is certain in all of that; f is F about the middle of
/// the cube, c.
///
/// With corners a away, v = y - c, and the ball's radius r about x = c - w: in the ball
/// r^2 - |y - x|^2 >= 0, of which any multiple m >= 0 may be taken away from F (the S-procedure:
/// Boyd and Vandenberghe 2004, "Convex Optimization", appendix B). With the value, slope and second
/// derivatives A of F at c, and a bound T of the third ones, what is left is at least
///
///     F - m (r^2 - |w|^2) - T a^3 / 6 + (grad F + 2 m w) v + v (A + 2 m) v / 2
///
/// and m is 0, or what leaves no slope along w. As the second makes up for the sphere's curvature,
/// large cubes are free where the sphere touches the surface, too: what is too large for them are
/// third derivatives.
[[nodiscard]] bool isOnOneSide(const CubeInBall& part, const TpmsPattern& pattern,
                               const PatternExpansion& f, double side);

}  // namespace cutwater::detail
