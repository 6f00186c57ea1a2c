#include <Cutwater/CutCells/Detail/Quadrature/RegionRule.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"

namespace cutwater::test {
namespace {

using Polygon = std::vector<Vec3<double>>;

/// Calls visit(powers) for the monomials up to a degree.
template <typename Visit>
std::size_t forMonomials(int degree, int variables, const Visit& visit) {
  std::size_t count = 0;
  for (int p = 0; p <= degree; ++p) {
    for (int q = 0; p + q <= degree; ++q) {
      for (int r = 0; r <= (variables == 3 ? degree - p - q : 0); ++r) {
        visit(std::array{p, q, r});
        ++count;
      }
    }
  }
  return count;
}

/// The sides of a box, counterclockwise from without: the low and the high one of each axis.
std::vector<Polygon> sidesOf(const Box<double>& box) {
  std::vector<Polygon> sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isHigh : {false, true}) {
      Polygon side(4, isHigh ? box.upper : box.lower);
      const int first = (axis + 1) % 3;
      const int second = (axis + 2) % 3;
      for (std::size_t k = 0; k < 4; ++k) {
        side[k][first] = k == 1 || k == 2 ? box.upper[first] : box.lower[first];
        side[k][second] = k > 1 ? box.upper[second] : box.lower[second];
      }
      if (!isHigh) std::ranges::reverse(side);
      sides.push_back(side);
    }
  }
  return sides;
}

std::vector<PolyhedronRule::Side> closing(const std::vector<Polygon>& polygons, bool isReversed) {
  std::vector<PolyhedronRule::Side> sides;
  for (const auto& polygon : polygons) sides.push_back({polygon, isReversed});
  return sides;
}

/// In the order of CutCells::Moments.
template <typename Integral>
std::vector<double> momentsOf(int degree, const Integral& integral) {
  std::vector<double> moments;
  for (const auto& powers : kOrder) {
    if (degreeOf(powers) <= degree) moments.push_back(integral(powers));
  }
  return moments;
}

/// Dirichlet's integrals.
TEST(RegionRuleTest, OfTetrahedraAreExactUpToTheirDegree) {
  const std::array<Vec3<double>, 4> p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::vector<Polygon> sides{
      {p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[0], p[3], p[2]}, {p[1], p[2], p[3]}};
  const auto integral = [](const Powers& powers) {
    return factorial(powers[0]) * factorial(powers[1]) * factorial(powers[2]) /
           factorial(degreeOf(powers) + 3);
  };
  for (int degree = 0; degree <= CutCells::Moments::kHighest; ++degree) {
    PolyhedronRule rule(degree);
    const auto moments = momentsOf(degree, integral);
    const auto points = rule.of(closing(sides, false), moments, {});
    const auto count = forMonomials(degree, 3, [&](const Powers& powers) {
      double sum = 0;
      for (const auto& [at, weight] : points) sum += weight * monomial(at, powers);
      EXPECT_NEAR(sum, integral(powers), 1e-15);
    });
    EXPECT_LE(points.size(), count);
    for (const auto& [at, weight] : points) {
      EXPECT_GT(weight, 0);
      EXPECT_GT(std::min({at.x, at.y, at.z, 1 - at.x - at.y - at.z}), 0);
    }
  }
}

/// A box less another one in it, which touches one of its sides, by closed forms; with sides from
/// without, and reversed.
TEST(RegionRuleTest, OfABoxWithADent) {
  const Box<double> box{{-0.4, 0.1, -0.7}, {0.8, 1.1, 0.9}};
  const Vec3<double> about{0.15, 0.7, 0.2};
  for (int axis = 0; axis < 3; ++axis) {
    Box<double> dent{{-0.1, 0.3, -0.2}, {0.5, 0.9, 0.4}};
    dent.upper[axis] = box.upper[axis];
    auto sides = sidesOf(box);
    auto inner = sidesOf(dent);
    // The open side of the dent is a hole in that of the box, cut open from its first corner.
    const auto open = 2 * static_cast<std::size_t>(axis) + 1;
    auto hole = inner[open];
    std::ranges::reverse(hole);
    hole.push_back(hole.front());
    auto& outer = sides[open];
    outer.push_back(outer.front());
    outer.insert(outer.end(), hole.begin(), hole.end());
    inner.erase(inner.begin() + static_cast<std::ptrdiff_t>(open));
    for (auto& side : inner) std::ranges::reverse(side);
    sides.insert(sides.end(), inner.begin(), inner.end());
    for (const bool isReversed : {false, true}) {
      auto turned = sides;
      for (auto& side : turned) {
        if (isReversed) std::ranges::reverse(side);
      }
      for (const int degree : {0, 1, 3, 4}) {
        PolyhedronRule rule(degree);
        const auto integral = [&](const Powers& powers) {
          return ofBox(powers, {box.lower - about, box.upper - about}) -
                 ofBox(powers, {dent.lower - about, dent.upper - about});
        };
        const auto moments = momentsOf(degree, integral);
        const auto points = rule.of(closing(turned, isReversed), moments, about);
        const auto count = forMonomials(degree, 3, [&](const Powers& powers) {
          double sum = 0;
          for (const auto& [at, weight] : points) sum += weight * monomial(at - about, powers);
          EXPECT_NEAR(sum, integral(powers), 1e-14);
        });
        EXPECT_LE(points.size(), count);
        for (const auto& [at, weight] : points) {
          EXPECT_GT(weight, 0);
          EXPECT_TRUE(box.contains(at));
          EXPECT_FALSE(dent.contains(at));
        }
      }
    }
  }
}

TEST(RegionRuleTest, OfAFrameInAPlane) {
  const auto rectangle = [](double low, double high, bool isHole) {
    std::vector<PlaneRule::Point> corners{{low, low}, {high, low}, {high, 1}, {low, 1}};
    if (isHole) std::ranges::reverse(corners);
    return corners;
  };
  std::vector<PlaneRule::Edge> rim;
  for (const bool isHole : {false, true}) {
    const auto corners = rectangle(isHole ? 0.25 : 0, isHole ? 0.5 : 1, isHole);
    for (std::size_t k = 0; k < 4; ++k) rim.push_back({corners[k], corners[(k + 1) % 4]});
  }
  const Box<double> outer{{0, 0, 0}, {1, 1, 1}};
  const Box<double> hole{{0.25, 0.25, 0}, {0.5, 1, 1}};
  for (int degree = 0; degree <= CutCells::Moments::kHighest; ++degree) {
    PlaneRule rule(degree);
    const auto points = rule.of(rim);
    const auto count = forMonomials(degree, 2, [&](const Powers& powers) {
      double sum = 0;
      for (const auto& [at, weight] : points) {
        sum += weight * monomial({at[0], at[1], 0}, powers);
      }
      EXPECT_NEAR(sum, ofBox(powers, outer) - ofBox(powers, hole), 1e-15);
    });
    EXPECT_LE(points.size(), count);
    for (const auto& [at, weight] : points) {
      EXPECT_GT(weight, 0);
      EXPECT_TRUE(outer.contains(Vec3<double>{at[0], at[1], 0.5}));
      EXPECT_FALSE(hole.contains(Vec3<double>{at[0], at[1], 0.5}));
    }
  }
}

/// Both sides of a sheet have no volume between them, but for rounding.
TEST(RegionRuleTest, WhatHasNoSizeHasNoWeight) {
  const Polygon there{{0, 0, 0.1}, {1, 0, 0.2}, {1, 1, 0.7}, {0, 1, 0.6}};
  auto back = there;
  std::ranges::reverse(back);
  PolyhedronRule rule(4);
  double sum = 0;
  const std::vector<double> none(35);
  for (const auto& [at, weight] : rule.of(closing({there, back}, false), none, {})) sum += weight;
  EXPECT_LT(sum, 1e-16);
  EXPECT_TRUE(rule.of({}, none, {}).empty());
  EXPECT_TRUE(PlaneRule(4).of({}).empty());
}

}  // namespace
}  // namespace cutwater::test
