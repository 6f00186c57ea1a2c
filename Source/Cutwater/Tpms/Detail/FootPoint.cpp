#include <Cutwater/Tpms/Detail/FootPoint.hpp>
#include <Cutwater/Tpms/Detail/PatternExpansion.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// Solves a x = b by Cramer's rule; a is symmetric.
Vec3<double> solved(const SymmetricMatrix& a, const Vec3<double>& b) {
  const double d = determinant(a);
  return Vec3<double>{dot(b, cross(a[1], a[2])), dot(a[0], cross(b, a[2])),
                      dot(a[0], cross(a[1], b))} /
         d;
}

/// The step of Newton's method for y - x + m grad F(y) = 0, F(y) = 0; where curvature would lead to
/// the farthest point instead, it is ignored.
Vec3<double> stepTowards(const Vec3<double>& x, const Vec3<double>& y, const PatternExpansion& f) {
  constexpr double kLongest = 0.5;
  const Vec3<double> away = y - x;
  const double multiplier = -dot(away, f.gradient) / lengthSquared(f.gradient);
  SymmetricMatrix matrix{Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  SymmetricMatrix curved = matrix;
  for (std::size_t i = 0; i < 3; ++i) curved[i] += multiplier * f.second[i];
  if (leastEigenvalue(curved) > 0.02) matrix = curved;
  const Vec3<double> rest = -(away + multiplier * f.gradient);
  const auto ofRest = solved(matrix, rest);
  const auto ofGradient = solved(matrix, f.gradient);
  const double change = (dot(f.gradient, ofRest) + f.value) / dot(f.gradient, ofGradient);
  const Vec3<double> step = ofRest - change * ofGradient;
  const double size = length(step);
  return size > kLongest ? (kLongest / size) * step : step;
}

/// See PatternDistance.
double freeRadiusAt(const TpmsPattern& pattern, const Vec3<double>& towardsX, double distance,
                    const PatternExpansion& f) {
  constexpr double kEverywhere = 1e9;
  const double slope = length(f.gradient);
  if (slope >= pattern.curvature() * distance) return kEverywhere;
  SymmetricMatrix second = f.second;
  if (dot(f.gradient, towardsX) < 0) {
    for (auto& column : second) column = -column;
  }
  const double margin =
      slope / distance + leastEigenvalue(second) - PatternExpansion::secondError(pattern);
  return std::max(3 * margin / pattern.thirdDerivative(), 0.0);
}

}  // namespace

std::optional<FootPoint> footPoint(const TpmsPattern& pattern, const Vec3<double>& x,
                                   const Vec3<double>& start) {
  constexpr int kMostSteps = 30;
  constexpr double kArrived = 2e-14;  // a few roundings of a coordinate in the cell
  Vec3<double> y = start;
  for (int i = 0; i < kMostSteps; ++i) {
    PatternExpansion f{};
    expandPattern(pattern, {&y, 1}, {&f, 1});
    if (!(lengthSquared(f.gradient) > 1e-12)) return {};
    const auto step = stepTowards(x, y, f);
    if (!isFinite(step)) return {};
    y += step;
    if (length(step) > kArrived) continue;
    const double distance = length(y - x);
    return FootPoint{y, distance, freeRadiusAt(pattern, x - y, distance, f)};
  }
  return {};
}

}  // namespace cutwater::detail
