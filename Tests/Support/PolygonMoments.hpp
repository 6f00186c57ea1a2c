#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

/// The moments of polygons and of what they bound, by quadrature: exact up to degree 4, but nothing
/// like the closed forms of the library.
class PolygonMoments {
 public:
  explicit PolygonMoments(const Vec3<double>& about)
      : about_(about), volume(35), area(35), vector(35) {}

  /// `sign`: 1 if the polygon's normal points out of what they bound.
  void add(std::span<const Vec3<double>> polygon, int sign) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      addTriangle(polygon[0] - about_, polygon[k - 1] - about_, polygon[k] - about_, sign);
    }
  }

 private:
  // Gauss and Legendre on [0, 1], exact up to degree 7: 4 of a monomial, and 2 of the squares and
  // products that collapse a cube into a tetrahedron.
  static constexpr std::array<double, 4> kAt{0.069431844202973712, 0.330009478207571868,
                                             0.669990521792428132, 0.930568155797026288};
  static constexpr std::array<double, 4> kWeight{0.173927422568726929, 0.326072577431273071,
                                                 0.326072577431273071, 0.173927422568726929};

  template <typename Visit>
  static void forMonomials(const Vec3<double>& p, Visit&& visit) {
    for (std::size_t i = 0; i <= 4; ++i) {
      for (std::size_t j = 0; i + j <= 4; ++j) {
        for (std::size_t k = 0; i + j + k <= 4; ++k) {
          double value = 1;
          for (std::size_t n = 0; n < i; ++n) value *= p.x;
          for (std::size_t n = 0; n < j; ++n) value *= p.y;
          for (std::size_t n = 0; n < k; ++n) value *= p.z;
          visit(CutCells::Moments::indexOf(i, j, k), value);
        }
      }
    }
  }

  void addTriangle(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c, int sign) {
    const auto twice = sign * cross(b - a, c - a);
    const double size = length(twice);
    const double sixfold = dot(a, twice);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const auto p = a + kAt[i] * (b - a) + kAt[i] * kAt[j] * (c - b);
        const double weight = kWeight[i] * kWeight[j] * kAt[i];
        forMonomials(p, [&](std::size_t n, double value) {
          area[n] += size * weight * value;
          vector[n] += weight * value * twice;
        });
        for (std::size_t k = 0; k < 4; ++k) {
          forMonomials(kAt[k] * p, [&](std::size_t n, double value) {
            volume[n] += sixfold * weight * kWeight[k] * kAt[k] * kAt[k] * value;
          });
        }
      }
    }
  }

  Vec3<double> about_;

 public:
  std::vector<double> volume;
  std::vector<double> area;
  std::vector<Vec3<double>> vector;
};

/// Within rounding of a monomial's integral over a cell of this width, or a face.
inline void expectMoment(double found, double expected, std::size_t monomial, double unit,
                         double width) {
  for (const std::size_t first : {1U, 4U, 10U, 20U}) {  // of each degree
    if (monomial >= first) unit *= width;
  }
  EXPECT_NEAR(found, expected, 2e-13 * unit) << monomial;
}

inline void expectMomentsOfArc(const CutCells& cells, std::size_t arc, double width) {
  PolygonMoments outline(cells.arcs.centroid[arc]);
  outline.add(cells.arcPolygons.of(arc), 1);
  const int axis = cells.arcs.axis[arc];
  for (std::size_t i = 0; i <= 4; ++i) {
    for (std::size_t j = 0; i + j <= 4; ++j) {
      const auto inSpace =
          std::array{CutCells::Moments::indexOf(0, i, j), CutCells::Moments::indexOf(i, 0, j),
                     CutCells::Moments::indexOf(i, j, 0)}[cells.arcs.axis[arc]];
      expectMoment(cells.moments.ofArc(arc)[CutCells::Moments::indexOf(i, j)],
                   outline.vector[inSpace][axis], inSpace, width * width, width);
    }
  }
}

/// `boundary`: all around the piece, about its centroid; `wall`: about its own.
inline void expectMomentsOfPiece(const CutCells& cells, std::size_t piece,
                                 const PolygonMoments& boundary, const PolygonMoments& wall,
                                 double width) {
  const double face = width * width;
  const auto& moments = cells.moments;
  for (std::size_t i = 0; i < 35; ++i) {
    expectMoment(moments.ofVolume(piece)[i], boundary.volume[i], i, face * width, width);
    expectMoment(moments.ofWall(piece)[i], wall.area[i], i, face, width);
    for (int axis = 0; axis < 3; ++axis) {
      expectMoment(moments.ofWallVector(piece)[i][axis], wall.vector[i][axis], i, face, width);
    }
  }
}

/// That moments are those of arcPolygons and wallPolygons.
inline void expectMomentsOfPolygons(const CutCells& cells) {
  const double width = maxComponent(cells.boxOf(cells.grid.first).size());
  std::vector<PolygonMoments> pieces;
  std::vector<PolygonMoments> walls;
  for (std::size_t p = 0; p < cells.pieces.volume.size(); ++p) {
    pieces.emplace_back(cells.pieces.centroid[p]);
    walls.emplace_back(cells.pieces.wallCentroid[p]);
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto outline = cells.arcPolygons.of(a);
    if (cells.arcs.below[a] < pieces.size()) pieces[cells.arcs.below[a]].add(outline, 1);
    if (cells.arcs.above[a] < pieces.size()) pieces[cells.arcs.above[a]].add(outline, -1);
    expectMomentsOfArc(cells, a, width);
  }
  for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
    const auto piece = cells.wallParts.piece[w];
    for (auto n = cells.firstWallPolygon[w]; n < cells.firstWallPolygon[w + 1]; ++n) {
      pieces[piece].add(cells.wallPolygons.of(n), -1);
      walls[piece].add(cells.wallPolygons.of(n), -1);
    }
  }
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    expectMomentsOfPiece(cells, p, pieces[p], walls[p], width);
  }
}

}  // namespace cutwater::test
