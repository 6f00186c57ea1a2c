#include <Cutwater/Tpms/Detail/CubeInBall.hpp>

#include <numbers>

namespace cutwater::detail {

namespace {

constexpr double kRounding = 1e-12;

/// isOnOneSide() with a given multiplier m.
bool isOnOneSideBy(double m, const CubeInBall& part, const TpmsPattern& pattern,
                   const PatternExpansion& f, double side) {
  const double corner = std::numbers::sqrt3 * part.half;
  const double third = pattern.thirdDerivative() / 6 * corner * corner * corner;
  const double room = part.radius * part.radius - lengthSquared(part.center);
  const double value = side * f.value - m * room - third - kRounding;
  if (!(value > 0)) return false;
  const Vec3<double> slope = side * f.gradient + 2 * m * part.center;
  // The least eigenvalue with which a quadratic function stays positive: in the cube, if something
  // is left of the value after what the slope takes there, and otherwise everywhere.
  const double rest = value - oneNorm(slope) * part.half;
  const double needed =
      rest > 0 ? -2 * rest / (corner * corner) : lengthSquared(slope) / (2 * value);
  return isPositiveDefinite(side, f.second,
                            2 * m - needed - PatternExpansion::secondError(pattern));
}

}  // namespace

bool isOnOneSide(const CubeInBall& part, const TpmsPattern& pattern, const PatternExpansion& f,
                 double side) {
  const double multiplier = -side * dot(f.gradient, part.center) / (2 * lengthSquared(part.center));
  return (multiplier > 0 && isOnOneSideBy(multiplier, part, pattern, f, side)) ||
         isOnOneSideBy(0, part, pattern, f, side);
}

}  // namespace cutwater::detail
