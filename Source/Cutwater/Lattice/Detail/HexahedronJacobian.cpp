// Private: whether trilinear hexahedra are inverted.

#include <Cutwater/Lattice/HexahedralCells.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// Bernstein coefficients of the determinant, a polynomial of degree 2 along each axis.
using Coefficients = std::array<std::array<std::array<double, 3>, 3>, 3>;

/// The edge from corner `from` along an axis.
Vec3<double> edge(const std::array<Vec3<double>, 8>& corners, std::size_t from, std::size_t axis) {
  return corners[from | 1U << axis] - corners[from & ~(std::size_t{1} << axis)];
}

double tripleProduct(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  return dot(a, cross(b, c));
}

/// The derivative along an axis is bilinear in the other two, with edges as coefficients. Of three
/// such factors, two depend on each coordinate; a product of linear Bernstein polynomials with
/// indices a and b is the quadratic one with index a + b divided by its binomial coefficient.
Coefficients coefficientsOf(const std::array<Vec3<double>, 8>& corners, double sign) {
  constexpr std::array<double, 3> kPerBinomial{1, 0.5, 1};
  Coefficients result{};
  for (std::size_t bits = 0; bits < 64; ++bits) {
    const std::size_t y0 = bits & 1U;
    const std::size_t z0 = bits >> 1U & 1U;
    const std::size_t x1 = bits >> 2U & 1U;
    const std::size_t z1 = bits >> 3U & 1U;
    const std::size_t x2 = bits >> 4U & 1U;
    const std::size_t y2 = bits >> 5U & 1U;
    const double weight = kPerBinomial[x1 + x2] * kPerBinomial[y0 + y2] * kPerBinomial[z0 + z1];
    result[x1 + x2][y0 + y2][z0 + z1] +=
        sign * weight *
        tripleProduct(edge(corners, y0 << 1U | z0 << 2U, 0), edge(corners, x1 | z1 << 2U, 1),
                      edge(corners, x2 | y2 << 1U, 2));
  }
  return result;
}

/// The coefficients of the lower or upper half along an axis, by de Casteljau's algorithm.
Coefficients halved(const Coefficients& whole, int axis, bool isUpper) {
  Coefficients half{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto at = [&](auto& all, std::size_t k) -> auto& {
        return axis == 0 ? all[k][i][j] : axis == 1 ? all[i][k][j] : all[i][j][k];
      };
      const double a = at(whole, 0);
      const double b = at(whole, 1);
      const double c = at(whole, 2);
      at(half, 0) = isUpper ? (a + 2 * b + c) / 4 : a;
      at(half, 1) = isUpper ? (b + c) / 2 : (a + b) / 2;
      at(half, 2) = isUpper ? c : (a + 2 * b + c) / 4;
    }
  }
  return half;
}

/// `least`: values above it count as positive in spite of rounding. `halvings`: the most that are
/// allowed.
bool isAbove(const Coefficients& coefficients, double least, int halvings) {
  bool isAbove = true;
  for (std::size_t i = 0; i < 27; ++i) {
    const std::array<std::size_t, 3> at{i % 3, i / 3 % 3, i / 9};
    const double value = coefficients[at[0]][at[1]][at[2]];
    const bool isCorner = std::ranges::find(at, 1U) == at.end();
    // Values at corners are coefficients.
    if (isCorner && !(value > least)) return false;
    isAbove = isAbove && value > least;
  }
  if (isAbove || halvings == 0) return isAbove;
  const int axis = halvings % 3;
  return cutwater::detail::isAbove(halved(coefficients, axis, false), least, halvings - 1) &&
         cutwater::detail::isAbove(halved(coefficients, axis, true), least, halvings - 1);
}

}  // namespace

bool hasPositiveJacobian(const std::array<Vec3<double>, 8>& corners, double sign) {
  // Far above the rounding of coordinates of usual size, and far below what a lattice can use.
  constexpr double kFlat = 1e-9;
  constexpr int kHalvings = 9;
  double product = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double longest = 0;
    for (std::size_t from = 0; from < 8; ++from) {
      longest = std::max(longest, length(edge(corners, from, axis)));
    }
    product *= longest;
  }
  return isAbove(coefficientsOf(corners, sign), kFlat * product, kHalvings);
}

double firstJacobian(const std::array<Vec3<double>, 8>& corners) {
  return tripleProduct(edge(corners, 0, 0), edge(corners, 0, 1), edge(corners, 0, 2));
}

}  // namespace cutwater::detail
