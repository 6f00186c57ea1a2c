// The cells in which a triangle has a part, and the planes and edges that bound these parts,
// against rational numbers, in which vertices and planes really are moved.

#include <Cutwater/CutCells/Detail/Tiles/TriangleSplitter.hpp>

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Rational = CGAL::Gmpq;
using Cell = std::array<std::int32_t, 3>;

constexpr int kCells = 4;
constexpr double kWidth = 0.25;

Rational powerOfHalf(int exponent) {
  Rational result(1);
  for (; exponent > 0; exponent -= 30) result /= Rational(1 << std::min(exponent, 30));
  return result;
}

struct RationalPart {
  std::vector<std::array<Rational, 3>> points;
  std::vector<FragmentEdge> edges;
};

/// The part above the plane, or below it.
RationalPart partBeside(const RationalPart& part, int axis, int plane, bool above) {
  const Rational position(plane * kWidth);
  const auto a = static_cast<std::size_t>(axis);
  RationalPart result;
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    const auto& p = part.points[i];
    const auto& q = part.points[(i + 1) % part.points.size()];
    const bool isAbove = p[a] > position;
    const bool goesAbove = q[a] > position;
    if (isAbove == above) {
      result.points.push_back(p);
      result.edges.push_back(part.edges[i]);
    }
    if (isAbove == goesAbove) continue;
    const Rational share = (position - p[a]) / (q[a] - p[a]);
    std::array<Rational, 3> point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = p[k] + share * (q[k] - p[k]);
    result.points.push_back(point);
    result.edges.push_back(goesAbove == above ? part.edges[i] : FragmentEdge{axis, plane});
  }
  return result;
}

/// By which amounts vertices are moved in units of their shifts, and planes: powers of 1/2 in the
/// proportions that MovedPredicates.hpp asks for.
struct Moves {
  std::array<int, 3> vertices;
  std::array<int, 3> planes;
};
/// Smaller than what coordinates in halves of a cell can decide, and coordinates an ulp beside
/// these.
constexpr Moves kForHalves{{40, 100, 220}, {400, 420, 440}};
constexpr Moves kForUlps{{300, 700, 1600}, {3000, 3150, 3300}};

std::map<Cell, RationalPart> partsOf(const std::array<MovedVertex, 3>& triangle,
                                     const Moves& moves) {
  RationalPart whole;
  for (int i = 0; i < 3; ++i) {
    const auto& vertex = triangle[static_cast<std::size_t>(i)];
    auto& point = whole.points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = Rational(vertex.position[static_cast<int>(k)]) +
                 Rational(vertex.shift[k]) * powerOfHalf(moves.vertices[k]) -
                 powerOfHalf(moves.planes[k]);
    }
    whole.edges.push_back({-1, i});
  }
  std::map<Cell, RationalPart> parts;
  const auto between = [](const RationalPart& part, int axis, int row) {
    return partBeside(partBeside(part, axis, row, true), axis, row + 1, false);
  };
  for (int i = 0; i < kCells; ++i) {
    const auto slab = between(whole, 0, i);
    for (int j = 0; j < kCells && !slab.points.empty(); ++j) {
      const auto row = between(slab, 1, j);
      for (int k = 0; k < kCells && !row.points.empty(); ++k) {
        const auto part = between(row, 2, k);
        if (!part.points.empty()) parts[{i, j, k}] = part;
      }
    }
  }
  return parts;
}

/// Whether the fragment has the edges of the part in the same order, wherever they begin.
bool hasEdges(const Fragment& fragment, const std::vector<FragmentEdge>& edges) {
  if (static_cast<std::size_t>(fragment.size) != edges.size()) return false;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    bool isSame = true;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      isSame = isSame && fragment.edges[(first + i) % edges.size()] == edges[i];
    }
    if (isSame) return true;
  }
  return false;
}

/// How often coordinates in halves of a cell, on planes and in the middle between these, are an ulp
/// off.
enum class OffByUlps { Never, Often, Always };

std::array<MovedVertex, 3> randomTriangle(std::mt19937& random, OffByUlps off) {
  std::array<MovedVertex, 3> triangle;
  for (auto& vertex : triangle) {
    for (int k = 0; k < 3; ++k) {
      double& x = vertex.position[k];
      x = (static_cast<int>(random() % 13) - 2) * 0.5 * kWidth;
      if (off == OffByUlps::Always && x == 0) x = kWidth;
      if (x != 0 && (off == OffByUlps::Always || (off == OffByUlps::Often && random() % 2 == 0))) {
        x = std::nextafter(x, random() % 2 == 0 ? 9.0 : -9.0);
      }
      vertex.shift[static_cast<std::size_t>(k)] = random() % 2 == 0 ? 1 : -1;
    }
  }
  return triangle;
}

struct Grid {
  Grid() {
    for (int i = 0; i <= kCells; ++i) positions.push_back(i * kWidth);
    planes = {{positions, positions, positions}};
  }
  std::vector<double> positions;
  GridPlanes planes;
};

bool hasEqualCorners(const std::array<MovedVertex, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return a.position == b.position || b.position == c.position || c.position == a.position;
}

void expectExactParts(OffByUlps off, int count) {
  const Grid grid;
  std::mt19937 random(1);
  std::size_t found = 0;
  for (int n = 0; n < count; ++n) {
    const auto triangle = randomTriangle(random, off);
    if (hasEqualCorners(triangle)) continue;
    auto expected = partsOf(triangle, off == OffByUlps::Never ? kForHalves : kForUlps);
    found += expected.size();
    TriangleSplitter(grid.planes).split(triangle, {0, 1, 2}, [&](const Fragment& fragment) {
      const auto part = expected.extract(fragment.cell);
      ASSERT_FALSE(part.empty()) << "triangle " << n;
      EXPECT_TRUE(hasEdges(fragment, part.mapped().edges)) << "triangle " << n;
    });
    EXPECT_TRUE(expected.empty()) << "triangle " << n;
  }
  EXPECT_GT(found, static_cast<std::size_t>(count));
}

TEST(CellSplittingTest, IsExactForTrianglesAlignedWithTheGrid) {
  expectExactParts(OffByUlps::Never, scaled(2000));
}

TEST(CellSplittingTest, IsExactForTrianglesAnUlpBesideIt) {
  expectExactParts(OffByUlps::Often, scaled(300));
}

/// Twice the area vector of a polygon.
template <typename Points, typename Number>
std::array<Number, 3> areaOf(const Points& points, std::size_t size) {
  std::array<Number, 3> sum{};
  for (std::size_t i = 2; i < size; ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto c = (a + 1) % 3;
      const auto d = (a + 2) % 3;
      const auto side = [&](std::size_t k, std::size_t axis) -> Number {
        return Number(points[k][axis]) - Number(points[0][axis]);
      };
      sum[a] += side(i - 1, c) * side(i, d) - side(i - 1, d) * side(i, c);
    }
  }
  return sum;
}

// Where a wall passes through a plane of the grid at an angle of an ulp, points computed along the
// wrong trace would be anywhere on it.
TEST(CellSplittingTest, AreasAreRightForTrianglesInAPlaneUpToAnUlp) {
  const Grid grid;
  std::mt19937 random(3);
  for (int n = 0; n < scaled(300); ++n) {
    auto triangle = randomTriangle(random, OffByUlps::Always);
    const auto axis = static_cast<int>(random() % 3);
    for (auto& vertex : triangle) {
      vertex.position[axis] = std::nextafter(0.5, random() % 2 == 0 ? 9.0 : -9.0);
    }
    if (hasEqualCorners(triangle)) continue;
    const auto expected = partsOf(triangle, kForUlps);
    TriangleSplitter(grid.planes).split(triangle, {0, 1, 2}, [&](const Fragment& fragment) {
      const auto& part = expected.at(fragment.cell);
      const auto exact = areaOf<decltype(part.points), Rational>(part.points, part.points.size());
      std::array<std::array<double, 3>, Fragment::kMost> points{};
      const auto size = static_cast<std::size_t>(fragment.size);
      for (std::size_t i = 0; i < size; ++i) {
        points[i] = {fragment.points[i].x, fragment.points[i].y, fragment.points[i].z};
      }
      const auto found = areaOf<decltype(points), double>(points, size);
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(found[a], CGAL::to_double(exact[a]), 1e-15) << "triangle " << n;
      }
    });
  }
}

}  // namespace
}  // namespace cutwater::test
