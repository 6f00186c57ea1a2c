#include <Cutwater/Tpms/FootPoint.hpp>
#include <Cutwater/Tpms/PatternBatch.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater::detail {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
/// For second derivatives by differences of gradients, in radians.
constexpr double kStep = 1e-5;

/// F with first and second derivatives, the latter as columns.
struct Expansion {
  double value;
  Vec3<double> gradient;
  std::array<Vec3<double>, 3> second;
};

Expansion expandedAt(const TpmsPattern& pattern, const Vec3<double>& place) {
  PatternBatch<double> batch;  // NOLINT(cppcoreguidelines-pro-type-member-init): four are filled
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = i == axis + 1 ? kStep : 0;
      batch.turns[axis][i] = (place[static_cast<int>(axis)] + step) / kTwoPi;
    }
  }
  samplePattern(pattern.kind(), batch, 4);
  const auto gradient = [&](std::size_t i) {
    return Vec3<double>{batch.gradient[0][i], batch.gradient[1][i], batch.gradient[2][i]};
  };
  Expansion result{batch.value[0], gradient(0), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    result.second[i] = (gradient(i + 1) - result.gradient) / kStep;
  }
  // Symmetric but for rounding and the step's length.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j) {
      auto& a = result.second[static_cast<std::size_t>(i)][j];
      auto& b = result.second[static_cast<std::size_t>(j)][i];
      a = b = 0.5 * (a + b);
    }
  }
  return result;
}

using Columns = std::array<Vec3<double>, 3>;

double determinant(const Columns& a) {
  return dot(a[0], cross(a[1], a[2]));
}

/// a x = b, by Cramer's rule; a is symmetric.
Vec3<double> solved(const Columns& a, const Vec3<double>& b) {
  const double d = determinant(a);
  return Vec3<double>{dot(b, cross(a[1], a[2])), dot(a[0], cross(b, a[2])),
                      dot(a[0], cross(a[1], b))} /
         d;
}

/// The least eigenvalue of a symmetric matrix, in closed form (Smith 1961, "Eigenvalues of a
/// symmetric 3 x 3 matrix").
double leastEigenvalue(Columns a) {
  const double mean = (a[0].x + a[1].y + a[2].z) / 3;
  for (int i = 0; i < 3; ++i) a[static_cast<std::size_t>(i)][i] -= mean;
  const double spread =
      std::sqrt((lengthSquared(a[0]) + lengthSquared(a[1]) + lengthSquared(a[2])) / 6);
  if (!(spread > 0)) return mean;
  for (auto& column : a) column = column / spread;
  const double angle = std::acos(std::clamp(0.5 * determinant(a), -1.0, 1.0)) / 3;
  return mean + 2 * spread * std::cos(angle + kTwoPi / 3);
}

/// The step of Newton's method for y - x + m grad F(y) = 0, F(y) = 0; where curvature would lead to
/// the farthest point instead, as if there were none.
Vec3<double> stepTowards(const Vec3<double>& x, const Vec3<double>& y, const Expansion& f) {
  constexpr double kLongest = 0.5;
  const Vec3<double> away = y - x;
  const double multiplier = -dot(away, f.gradient) / lengthSquared(f.gradient);
  Columns matrix{Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Columns curved = matrix;
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
                    const Expansion& f) {
  constexpr double kEverywhere = 1e9;
  const double slope = length(f.gradient);
  if (slope >= pattern.curvature() * distance) return kEverywhere;
  Columns second = f.second;
  if (dot(f.gradient, towardsX) < 0) {
    for (auto& column : second) column = -column;
  }
  // What differences miss: half a step of third derivatives in each column, and rounding.
  const double missed = kStep * pattern.thirdDerivative() + 1e-9;
  const double margin = slope / distance + leastEigenvalue(second) - missed;
  return std::max(3 * margin / pattern.thirdDerivative(), 0.0);
}

}  // namespace

std::optional<FootPoint> footPoint(const TpmsPattern& pattern, const Vec3<double>& x,
                                   const Vec3<double>& start) {
  constexpr int kMostSteps = 30;
  constexpr double kArrived = 2e-14;  // some roundings of a coordinate in the cell
  Vec3<double> y = start;
  for (int i = 0; i < kMostSteps; ++i) {
    const auto f = expandedAt(pattern, y);
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
