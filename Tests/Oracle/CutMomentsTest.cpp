// The moments of cells that a tetrahedron cuts, against rational numbers: what of it is in a cell,
// by clipping, and integrals term by term.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <cmath>
#include <numeric>
#include <random>

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Exact = CGAL::Gmpq;
using ExactVector = std::array<Exact, 3>;
using ExactPolygon = std::vector<ExactVector>;
using MonomialPowers = std::array<std::size_t, 3>;

constexpr std::size_t kMonomialCount = 35;

ExactVector difference(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Exact product(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
ExactVector normalOf(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The points p with n . p <= d.
struct HalfSpace {
  ExactVector n;
  Exact d;
};

/// The part of a convex polygon in a half-space (Sutherland and Hodgman 1974).
ExactPolygon within(const ExactPolygon& polygon, const HalfSpace& space) {
  ExactPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    const Exact atP = product(space.n, p) - space.d;
    const Exact atQ = product(space.n, q) - space.d;
    if (atP <= 0) result.push_back(p);
    if ((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0)) {
      auto& cut = result.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) cut[k] = p[k] + atP / (atP - atQ) * (q[k] - p[k]);
    }
  }
  return result;
}

Exact factorial(std::size_t n) {
  Exact result(1);
  for (std::size_t i = 2; i <= n; ++i) result *= Exact(static_cast<int>(i));
  return result;
}

/// The mean of a monomial over a simplex: each coordinate is a sum over corners of barycentric
/// coordinates b times those of corners, so the product is one of all choices of corners, and the
/// mean of b^e is d! e! / (|e| + d)!.
Exact meanOf(const MonomialPowers& powers, const std::vector<ExactVector>& corners) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < 3; ++axis) axes.insert(axes.end(), powers[axis], axis);
  std::vector<std::size_t> choice(axes.size());
  Exact sum(0);
  while (true) {
    Exact term(1);
    std::vector<std::size_t> exponents(corners.size());
    for (std::size_t i = 0; i < axes.size(); ++i) {
      term *= corners[choice[i]][axes[i]];
      ++exponents[choice[i]];
    }
    for (const auto exponent : exponents) term *= factorial(exponent);
    sum += term;
    std::size_t i = 0;
    while (i < choice.size() && ++choice[i] == corners.size()) choice[i++] = 0;
    if (i == choice.size()) break;
  }
  const auto d = corners.size() - 1;
  return sum * factorial(d) / factorial(axes.size() + d);
}

/// What convex polygons bound, about a point.
struct ExactMoments {
  std::vector<Exact> volume = std::vector<Exact>(kMonomialCount);
  std::vector<double> area = std::vector<double>(kMonomialCount);
  /// Of the polygons that close the wall, and of the wall.
  std::vector<ExactVector> vector = std::vector<ExactVector>(kMonomialCount);
  std::vector<ExactVector> wallVector = std::vector<ExactVector>(kMonomialCount);

  /// With its normal outwards; in the wall, or closing it.
  void add(const ExactPolygon& polygon, const ExactVector& about, bool isWall) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const auto a = difference(polygon[0], about);
      const auto b = difference(polygon[k - 1], about);
      const auto c = difference(polygon[k], about);
      const auto twice = normalOf(difference(b, a), difference(c, a));
      const double size = std::sqrt(CGAL::to_double(product(twice, twice))) / 2;
      for (std::size_t i = 0; i <= 4; ++i) {
        for (std::size_t j = 0; i + j <= 4; ++j) {
          for (std::size_t n = 0; i + j + n <= 4; ++n) {
            const auto at = CutCells::Moments::indexOf(i, j, n);
            const auto mean = meanOf({i, j, n}, {a, b, c});
            volume[at] += product(a, twice) / 6 * meanOf({i, j, n}, {ExactVector{}, a, b, c});
            if (isWall) area[at] += size * CGAL::to_double(mean);
            for (std::size_t axis = 0; axis < 3; ++axis) {
              (isWall ? wallVector : vector)[at][axis] += mean * twice[axis] / 2;
            }
          }
        }
      }
    }
  }
};

ExactVector exact(const Vec3<double>& p) {
  return {Exact(p.x), Exact(p.y), Exact(p.z)};
}

/// A tetrahedron's faces and its part in cells.
class ExactTetrahedron {
 public:
  explicit ExactTetrahedron(const PolygonSoup& soup) {
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      ExactPolygon face;
      for (const auto corner : soup.polygon(i)) face.push_back(exact(soup.points[corner]));
      const auto n = normalOf(difference(face[1], face[0]), difference(face[2], face[0]));
      spaces_.push_back({n, product(n, face[0])});
      faces_.push_back(face);
    }
  }

  [[nodiscard]] ExactMoments within(const Box<double>& cell, const Vec3<double>& about) const {
    ExactMoments result;
    for (const auto& face : faces_) {
      result.add(clipped(face, spacesOf(cell)), exact(about), true);
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool isHigh : {false, true})
        result.add(open(cell, axis, isHigh), exact(about), false);
    }
    return result;
  }
  /// Its part of a cell's face.
  [[nodiscard]] ExactPolygon open(const Box<double>& cell, int axis, bool isHigh) const {
    return clipped(faceOf(cell, axis, isHigh), spaces_);
  }

 private:
  static ExactPolygon clipped(ExactPolygon polygon, const std::vector<HalfSpace>& spaces) {
    for (const auto& space : spaces) polygon = test::within(polygon, space);
    return polygon;
  }
  static std::vector<HalfSpace> spacesOf(const Box<double>& cell) {
    std::vector<HalfSpace> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ExactVector n{};
      n[axis] = Exact(1);
      result.push_back({n, Exact(cell.upper[static_cast<int>(axis)])});
      n[axis] = Exact(-1);
      result.push_back({n, -Exact(cell.lower[static_cast<int>(axis)])});
    }
    return result;
  }
  static ExactPolygon faceOf(const Box<double>& cell, int axis, bool isHigh) {
    ExactPolygon face;
    for (const auto& [alongFirst, alongSecond] :
         {std::pair(false, false), {true, false}, {true, true}, {false, true}}) {
      auto p = cell.lower;
      p[axis] = isHigh ? cell.upper[axis] : cell.lower[axis];
      if (alongFirst) p[(axis + 1) % 3] = cell.upper[(axis + 1) % 3];
      if (alongSecond) p[(axis + 2) % 3] = cell.upper[(axis + 2) % 3];
      face.push_back(exact(p));
    }
    if (!isHigh) std::reverse(face.begin(), face.end());
    return face;
  }

  std::vector<ExactPolygon> faces_;
  std::vector<HalfSpace> spaces_;
};

/// In shares of what the moment of a box around it with sides of `size` would be at most.
double unitOf(const MonomialPowers& powers, const Vec3<double>& size) {
  return std::pow(size.x, powers[0]) * std::pow(size.y, powers[1]) * std::pow(size.z, powers[2]);
}

/// Compares all pieces, each of which is all there is in its cell.
void expectAsExact(const CutCells& cells, const ExactTetrahedron& tetrahedron,
                   const Vec3<double>& size, double error) {
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    const auto cell = cells.boxOf(cells.cells.index[cells.pieces.cell[p]]);
    ASSERT_EQ(cells.cells.firstPiece[cells.pieces.cell[p]], p);
    const auto ofPiece = tetrahedron.within(cell, cells.pieces.centroid[p]);
    const auto ofWall = tetrahedron.within(cell, cells.pieces.wallCentroid[p]);
    const double volume = cells.pieces.volume[p];
    const double area = cells.pieces.wallArea[p];
    for (std::size_t i = 0; i <= 4; ++i) {
      for (std::size_t j = 0; i + j <= 4; ++j) {
        for (std::size_t k = 0; i + j + k <= 4; ++k) {
          const auto at = CutCells::Moments::indexOf(i, j, k);
          const double unit = error * unitOf({i, j, k}, size);
          EXPECT_NEAR(cells.moments.ofVolume(p)[at], CGAL::to_double(ofPiece.volume[at]),
                      unit * volume)
              << i << j << k;
          EXPECT_NEAR(cells.moments.ofWall(p)[at], ofWall.area[at], unit * area) << i << j << k;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(cells.moments.ofWallVector(p)[at][static_cast<int>(axis)],
                        CGAL::to_double(ofWall.wallVector[at][axis]), unit * area)
                << i << j << k;
          }
        }
      }
    }
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const int axis = cells.arcs.axis[a];
    const auto cell = cells.boxOf(cells.arcs.cell[a]);
    ExactMoments exactly;
    exactly.add(tetrahedron.open(cell, axis, false), exact(cells.arcs.centroid[a]), false);
    for (std::size_t i = 0; i <= 4; ++i) {
      for (std::size_t j = 0; i + j <= 4; ++j) {
        MonomialPowers powers{i, j, 0};
        if (axis < 2) powers = axis == 0 ? MonomialPowers{0, i, j} : MonomialPowers{i, 0, j};
        const auto at = CutCells::Moments::indexOf(powers[0], powers[1], powers[2]);
        const double expected =
            -CGAL::to_double(exactly.vector[at][static_cast<std::size_t>(axis)]);
        EXPECT_NEAR(cells.moments.ofArc(a)[CutCells::Moments::indexOf(i, j)], expected,
                    error * unitOf(powers, size) * cells.arcs.area[a])
            << i << j;
      }
    }
  }
}

PolygonSoup randomTetrahedron(std::mt19937& random) {
  auto soup = tetrahedron();
  std::uniform_real_distribution<double> number(0.05, 0.95);
  const auto volume = [&] {
    const auto& p = soup.points;
    return dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) / 6;
  };
  const bool isPositive = volume() > 0;
  do {
    for (auto& p : soup.points) p = {number(random), number(random), number(random)};
  } while ((volume() > 0) != isPositive || std::abs(volume()) < 0.01);
  return soup;
}

CutCells insideOf(const PolygonSoup& soup, const Vec3<double>& size, int n) {
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), FluidSide::Inside)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, size), IndexBox::ofSize(n, n, n)},
           {.moments = 4});
}

TEST(CutMomentsTest, OfTetrahedraPlacedAnyhow) {
  std::mt19937 random(11);
  std::size_t compared = 0;
  for (int n = 0; n < scaled(2) && !HasFailure(); ++n) {
    const auto soup = randomTetrahedron(random);
    for (const int cellsAlong : {1, 2}) {
      const double h = 1.0 / cellsAlong;
      const auto cells = insideOf(soup, {h, h, h}, cellsAlong);
      expectAsExact(cells, ExactTetrahedron(soup), {h, h, h}, 1e-13);
      compared += cells.arcs.area.size();
    }
  }
  EXPECT_GT(compared, 8U);
}

/// Squashed to a millionth, in cells that are as flat or not: relative to what they are, and to the
/// power of how thin.
TEST(CutMomentsTest, OfThinTetrahedra) {
  std::mt19937 random(12);
  for (int n = 0; n < scaled(1) && !HasFailure(); ++n) {
    auto soup = randomTetrahedron(random);
    const double thin = 0x1p-20;
    for (auto& p : soup.points) p.z = 0.375 + thin * p.z;
    const ExactTetrahedron tetrahedron(soup);
    // Coordinates are rounded to 1e-16, which is 1e-10 of the thickness.
    expectAsExact(insideOf(soup, {1, 1, 1}, 1), tetrahedron, {1, 1, thin}, 1e-13);
    expectAsExact(insideOf(soup, {0.5, 0.5, 1}, 2), tetrahedron, {0.5, 0.5, thin}, 1e-9);
  }
}

}  // namespace
}  // namespace cutwater::test
