#include <Cutwater/Grid/Detail/PlaneFraction.hpp>

#include <algorithm>
#include <array>

namespace cutwater::detail {

namespace {

/// The fraction of [0, 1]^3 in which <m, x> < a, for 0 <= m in ascending order with sum 1, and 0 <=
/// a <= 1/2.
double halfFraction(const std::array<double, 3>& m, double a) {
  const auto& [m1, m2, m3] = m;
  if (a < m1) return a * a * a / (6 * m1 * m2 * m3);
  if (a < m2) return (3 * a * (a - m1) + m1 * m1) / (6 * m2 * m3);
  const double m12 = m1 + m2;
  if (a >= m12) return a < m3 ? (2 * a - m12) / (2 * m3) : 0.5;
  const auto cut = [=](double side) { return side * side * (side - 3 * a); };
  if (a < m3) return (a * a * (3 * m12 - a) + cut(m1) + cut(m2)) / (6 * m1 * m2 * m3);
  return (a * a * (3 - 2 * a) + cut(m1) + cut(m2) + cut(m3)) / (6 * m1 * m2 * m3);
}

/// Below it, differences of third powers are too inaccurate: such a component of the gradient
/// counts as 0.
constexpr double kSmallest = 1e-5;

}  // namespace

double planeFraction(double value, const Vec3<double>& gradient) {
  const double whole = oneNorm(gradient);
  const double atOrigin = value < 0 ? 1 : 0;
  if (!(whole > 0) || !(std::abs(value) < whole)) return atOrigin;
  const auto parts = abs(gradient) / whole;
  std::array<double, 3> m{parts.x, parts.y, parts.z};
  std::ranges::sort(m);
  if (m[0] < kSmallest) m[0] = 0;
  // Uses the symmetry about the origin.
  const double a = 0.5 - std::abs(value) / whole;
  const double fraction = a > 0 ? std::clamp(halfFraction(m, a), 0.0, 0.5) : 0;
  return value < 0 ? 1 - fraction : fraction;
}

}  // namespace cutwater::detail
