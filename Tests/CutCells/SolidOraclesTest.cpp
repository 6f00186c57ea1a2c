// Cells of solids against integrals that are known otherwise: balls in boxes, and the ellipse and
// the ellipsoid of Saye 2015.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Real = long double;
constexpr auto kLongPi = std::numbers::pi_v<Real>;

/// By the double exponential rule (Takahasi and Mori 1974), which does not mind roots at the ends.
Real integralOf(const std::function<Real(Real)>& f, Real from, Real to) {
  constexpr int kPoints = 100;
  constexpr Real kReach = 3.6L;
  constexpr Real kStep = kReach / kPoints;
  Real sum = 0;
  for (int i = -kPoints; i <= kPoints; ++i) {
    const Real t = static_cast<Real>(i) * kStep;
    const Real bend = kLongPi / 2 * std::sinh(t);
    const Real weight = kLongPi / 2 * std::cosh(t) / (std::cosh(bend) * std::cosh(bend));
    sum += weight * f((from + to) / 2 + (to - from) / 2 * std::tanh(bend));
  }
  return kStep * sum * (to - from) / 2;
}

/// Between the ends, sorted, with those of `inner` that lie there.
std::vector<Real> breaksBetween(Real from, Real to, std::vector<Real> inner) {
  std::erase_if(inner, [&](Real at) { return !(from < at && at < to); });
  inner.push_back(from);
  inner.push_back(to);
  std::ranges::sort(inner);
  return inner;
}

Real rootOf(Real square) {
  return std::sqrt(std::max<Real>(0, square));
}

/// What a disc about the origin has in common with a rectangle.
Real discInRectangle(Real r, const Box<double>& box) {
  const Real low = std::max<Real>(box.lower.x, -r);
  const Real high = std::min<Real>(box.upper.x, r);
  if (!(low < high)) return 0;
  const auto half = [r](Real x) { return rootOf(r * r - x * x); };
  const auto ofHalf = [&](Real x) {  // its integral
    return (x * half(x) + r * r * std::asin(std::clamp<Real>(x / r, -1, 1))) / 2;
  };
  std::vector<Real> turns;
  for (const Real y : {Real{box.lower.y}, Real{box.upper.y}}) {
    turns.push_back(half(y));
    turns.push_back(-half(y));
  }
  const auto breaks = breaksBetween(low, high, std::move(turns));
  Real area = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const Real a = breaks[i];
    const Real b = breaks[i + 1];
    for (const Real side : {Real{1}, Real{-1}}) {
      const Real middle = side * half((a + b) / 2);
      const bool isArc = box.lower.y < middle && middle < box.upper.y;
      const Real line = std::clamp<Real>(middle, box.lower.y, box.upper.y);
      area += side * (isArc ? side * (ofHalf(b) - ofHalf(a)) : line * (b - a));
    }
  }
  return area;
}

/// What a ball about the origin has in common with a box.
Real ballInBox(Real radius, const Box<double>& box) {
  std::vector<Real> turns{-radius, radius};
  for (const Real x : {Real{0}, Real{box.lower.x}, Real{box.upper.x}}) {
    for (const Real y : {Real{0}, Real{box.lower.y}, Real{box.upper.y}}) {
      const Real height = rootOf(radius * radius - x * x - y * y);
      turns.push_back(height);
      turns.push_back(-height);
    }
  }
  const auto breaks = breaksBetween(box.lower.z, box.upper.z, std::move(turns));
  Real volume = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (!(breaks[i] < breaks[i + 1])) continue;
    volume +=
        integralOf([&](Real z) { return discInRectangle(rootOf(radius * radius - z * z), box); },
                   breaks[i], breaks[i + 1]);
  }
  return volume;
}

CellPlanes cellBetween(const Box<double>& box) {
  return cellsBetween({std::vector<double>{box.lower.x, box.upper.x},
                       {box.lower.y, box.upper.y},
                       {box.lower.z, box.upper.z}});
}

TEST(SolidOraclesTest, TheOracleKnowsTheWholeBallAndAnOctant) {
  const Real whole = 4 * kLongPi / 3;
  EXPECT_NEAR(static_cast<double>(ballInBox(1, {{-1, -1, -1}, {1, 1, 1}}) / whole), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(8 * ballInBox(1, {{0, 0, 0}, {2, 2, 2}}) / whole), 1, 1e-15);
  // A cap of height 0.3.
  const Real cap = kLongPi * 0.09L * (3 - 0.3L) / 3;
  EXPECT_NEAR(static_cast<double>(ballInBox(1, {{-2, 0.7, -2}, {2, 2, 2}}) / cap), 1, 1e-15);
}

/// As Strobl, Formella and Poeschel 2016 (J. Comput. Phys. 311) tested overlaps: boxes anywhere
/// about the ball, as small as meshes have them.
TEST(SolidOraclesTest, OverlapsOfBallsWithBoxesAreRightToRounding) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-1, 1);
  const Sphere<double> ball({0, 0, 0}, 1);
  const SolidCutter cutter(Solid<double>(ball), FluidSide::Inside, {.points = 6});
  double worst = 0;
  int cut = 0;
  for (int n = 0; n < scaled(600); ++n) {
    // The middle of a box of a twentieth of the radius, near the surface.
    auto middle = normalized(Vec3<double>{at(random), at(random), at(random)});
    middle *= 1 + 0.02 * at(random);
    const auto half = 0.025 * Vec3<double>{1 + 0.5 * at(random), 1 + 0.5 * at(random), 1};
    const Box<double> box{middle - half, middle + half};
    const auto cells = cutter.cut(cellBetween(box));
    if (cells.cellCount == 0) continue;
    ++cut;
    const auto size = box.size();
    const double found = check(cells).fluidVolume;
    worst = std::max(worst, std::abs(found - static_cast<double>(ballInBox(1, box))) /
                                (size.x * size.y * size.z));
  }
  std::printf("worst %.2e\n", worst);
  EXPECT_GT(cut, scaled(300));
  EXPECT_LT(worst, 1e-12);
}

/// Large boxes, whose faces the ball bulges through: within the error that the cell states.
TEST(SolidOraclesTest, OverlapsWithLargeBoxesAreWithinTheirErrors) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-1, 1);
  const Sphere<double> ball({0, 0, 0}, 1);
  const SolidCutter cutter(Solid<double>(ball), FluidSide::Inside, {.points = 6});
  for (int n = 0; n < scaled(40); ++n) {
    const Vec3<double> corner{at(random), at(random), at(random)};
    const Vec3<double> other{at(random), at(random), at(random)};
    const Box<double> box{min(corner, other), max(corner, other)};
    const auto size = box.size();
    const double whole = size.x * size.y * size.z;
    if (std::min({size.x, size.y, size.z}) < 0.05) continue;
    const auto cells = cutter.cut(cellBetween(box));
    if (cells.cellCount == 0) continue;
    const double off =
        std::abs(check(cells).fluidVolume - static_cast<double>(ballInBox(1, box))) / whole;
    EXPECT_LT(off, cells.cells.error[0] + 1e-13) << n;
    EXPECT_LT(off, 1e-5) << n;
  }
}

/// The level set x^2 + 4 y^2 + 9 z^2 - 1, which is no distance, in [-1.1, 1.1]^3.
Solid<double> levelSet() {
  const auto value = [](const Vec3<double>& p) {
    return p.x * p.x + 4 * p.y * p.y + 9 * p.z * p.z - 1;
  };
  // No gradient is longer in the box.
  const Guarantee<double> promise{.lipschitz = 2 * 1.1 * std::sqrt(1.0 + 16 + 81)};
  return FunctionSDF<double, decltype(value)>(value, promise);
}

CellPlanes cellsOfSaye(int n, bool isPlane = false) {
  std::vector<double> planes;
  for (int i = 0; i <= n; ++i) planes.push_back(-1.1 + 2.2 * i / n);
  if (isPlane) return cellsBetween({planes, planes, {-1, 1}});
  return cellsBetween({planes, planes, planes});
}

/// Errors fall nearly at the orders of his section 4, twice the points.
TEST(SolidOraclesTest, TheEllipsoidOfSayeFallsAtHisOrders) {
  const double volume = static_cast<double>(2 * kLongPi / 9);
  // By its formula with elliptic integrals, semi-axes 1, 1/2 and 1/3.
  const double cosine = 1.0 / 3;
  const double angle = std::acos(cosine);
  const double modulus = std::sqrt((0.25 - 1.0 / 9) / (0.25 * (1 - 1.0 / 9)));
  const double sine = std::sin(angle);
  const double area =
      2 * std::numbers::pi / 9 + std::numbers::pi / sine *
                                     (std::ellint_2(modulus, angle) * sine * sine +
                                      std::ellint_1(modulus, angle) * cosine * cosine);
  const auto solid = levelSet();
  for (const int points : {2, 3}) {
    const auto errorsOf = [&](int n) {
      const auto report =
          check(SolidCutter(solid, FluidSide::Inside, {.points = points, .tolerance = 1})
                    .cut(cellsOfSaye(n)));
      return std::array{std::abs(report.fluidVolume / volume - 1),
                        std::abs(report.wallArea / area - 1)};
    };
    const auto coarse = errorsOf(16);
    const auto fine = errorsOf(64);
    // Two halvings. Areas have orders of 3.6 and 5.0 here, volumes of 3.9 and 5.4.
    const double factor = std::pow(4, 2 * points - 1.1);
    for (const std::size_t of : {0, 1}) {
      EXPECT_LT(coarse[of], 1e-2) << points;
      EXPECT_LT(fine[of], std::max(1e-13, coarse[of] / factor)) << points;
      std::printf("q %d: %.2e %.2e\n", points, coarse[of], fine[of]);
    }
  }
}

TEST(SolidOraclesTest, TheEllipseOfSayeFallsToRounding) {
  const double area = static_cast<double>(kLongPi / 2);
  const double length = 4 * std::comp_ellint_2(std::sqrt(0.75));
  const auto solid = levelSet();
  const auto report = check(
      SolidCutter(solid, FluidSide::Inside, {.points = 6}).cutInPlane(cellsOfSaye(64, true), 0));
  EXPECT_NEAR(report.fluidVolume, area, 1e-13);
  EXPECT_NEAR(report.wallArea / length, 1, 1e-12);
}

}  // namespace
}  // namespace cutwater::test
