#include <Cutwater/Grid/Detail/CellPolygons.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace cutwater::detail {

namespace {

constexpr bool has(unsigned mask, int bit) {
  return ((mask >> static_cast<unsigned>(bit)) & 1U) != 0;
}

/// The places where the border of a face, counter-clockwise, passes from inside to outside or back.
struct FaceCuts {
  std::array<int, 4> corners;
  std::array<bool, 4> inside;

  FaceCuts(unsigned mask, int face) : corners(cubeFace(face)) {
    for (std::size_t n = 0; n < 4; ++n) inside[n] = has(mask, corners[n]);
  }

  static std::size_t next(std::size_t n) { return (n + 1) % 4; }
  [[nodiscard]] bool leaves(std::size_t n) const { return inside[n] && !inside[next(n)]; }
  [[nodiscard]] bool enters(std::size_t n) const { return !inside[n] && inside[next(n)]; }
  [[nodiscard]] int edge(std::size_t n) const {
    return cubeEdgeBetween(corners[n], corners[next(n)]);
  }
  /// Where the border entered the inside part that it leaves at n: the cut leads from there to n.
  [[nodiscard]] std::size_t partner(std::size_t n, bool joined) const {
    const std::size_t step = joined ? 1 : 3;
    for (n = (n + step) % 4; !enters(n);) n = (n + step) % 4;
    return n;
  }
};

/// Mask of the faces that a corner of a polygon lies in.
unsigned facesOf(int corner) {
  unsigned faces = 0;
  const bool isEdge = corner < 12;
  const auto [axis, lower] = isEdge ? cubeEdge(corner) : CubeEdge{-1, corner - 12};
  for (int a = 0; a < 3; ++a) {
    if (a != axis) faces |= 1U << static_cast<unsigned>(2 * a + ((lower >> a) & 1));
  }
  return faces;
}

}  // namespace

CubeEdge cubeEdge(int edge) {
  const int axis = edge / 4;
  const int rest = edge % 4;  // the other two coordinates, the lower axis first
  const int low = rest & ((1 << axis) - 1);
  return {axis, low | ((rest & ~((1 << axis) - 1)) << 1)};
}

int cubeEdgeBetween(int corner, int other) {
  const int axis = std::countr_zero(static_cast<unsigned>(corner ^ other));
  const int lower = corner & other;
  return 4 * axis + ((lower & ((1 << axis) - 1)) | ((lower >> (axis + 1)) << axis));
}

std::array<int, 4> cubeFace(int face) {
  const int axis = face / 2;
  const int u = 1 << (axis + 1) % 3;
  const int v = 1 << (axis + 2) % 3;
  const int at = (face & 1) << axis;
  if ((face & 1) != 0) return {at, at + u, at + u + v, at + v};
  return {at, at + v, at + u + v, at + u};
}

namespace {

bool isAmbiguous(unsigned inside, int face) {
  const FaceCuts cuts(inside, face);
  return cuts.inside[0] == cuts.inside[2] && cuts.inside[1] == cuts.inside[3] &&
         cuts.inside[0] != cuts.inside[1];
}

int findPolygons(unsigned inside, unsigned joined, std::array<CellPolygon, 4>& polygons) {
  // At each cut edge, the border of one of its faces leaves the solid, that of the other enters it.
  std::array<std::uint8_t, 12> next{};
  unsigned cut = 0;
  for (int face = 0; face < 6; ++face) {
    const FaceCuts cuts(inside, face);
    for (std::size_t n = 0; n < 4; ++n) {
      if (!cuts.leaves(n)) continue;
      const int from = cuts.edge(cuts.partner(n, has(joined, face)));
      next[static_cast<std::size_t>(from)] = static_cast<std::uint8_t>(cuts.edge(n));
      cut |= 1U << static_cast<unsigned>(from);
    }
  }
  int count = 0;
  while (cut != 0) {
    auto& polygon = polygons[static_cast<std::size_t>(count++)];
    polygon.count = 0;
    for (int edge = std::countr_zero(cut); has(cut, edge);
         edge = next[static_cast<std::size_t>(edge)]) {
      polygon.add(edge);
      cut &= ~(1U << static_cast<unsigned>(edge));
    }
  }
  return count;
}

/// What follows from the signs of the corners alone.
struct CellCase {
  unsigned ambiguous = 0;
  int count = 0;
  std::array<CellPolygon, 4> polygons{};  // if no face is joined
};

const CellCase& caseOf(unsigned inside) {
  static const std::array<CellCase, 256> all = [] {
    std::array<CellCase, 256> cases;
    for (unsigned n = 0; n < 256; ++n) {
      cases[n].count = findPolygons(n, 0, cases[n].polygons);
      for (int face = 0; face < 6; ++face) {
        if (isAmbiguous(n, face)) cases[n].ambiguous |= 1U << static_cast<unsigned>(face);
      }
    }
    return cases;
  }();
  return all[inside];
}

}  // namespace

unsigned ambiguousFaces(unsigned inside) {
  return caseOf(inside).ambiguous;
}

int surfacePolygons(unsigned inside, unsigned joined, std::array<CellPolygon, 4>& polygons) {
  if (joined != 0) return findPolygons(inside, joined, polygons);
  const auto& known = caseOf(inside);
  std::copy_n(known.polygons.begin(), known.count, polygons.begin());
  return known.count;
}

int facePolygons(unsigned inside, unsigned joined, int face, std::array<CellPolygon, 2>& polygons) {
  const FaceCuts cuts(inside, face);
  int count = 0;
  std::array<bool, 4> seen{};
  for (std::size_t begin = 0; begin < 4; ++begin) {
    if (!cuts.inside[begin] || seen[begin]) continue;
    auto& polygon = polygons[static_cast<std::size_t>(count++)];
    polygon.count = 0;
    for (std::size_t n = begin; !seen[n];) {
      seen[n] = true;
      polygon.add(12 + cuts.corners[n]);
      if (cuts.leaves(n)) {
        polygon.add(cuts.edge(n));
        n = cuts.partner(n, has(joined, face));
        polygon.add(cuts.edge(n));
      }
      n = FaceCuts::next(n);
    }
  }
  return count;
}

namespace {

/// A table over the pieces of a polygon from corner i to corner j > i.
template <typename V>
using PieceTable = std::array<std::array<V, CellPolygon::kMost>, CellPolygon::kMost>;

bool isWithinFace(const CellPolygon& polygon) {
  unsigned faces = ~0U;
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    faces &= facesOf(polygon.corners[i]);
  }
  return faces != 0;
}

}  // namespace

int triangulate(const CellPolygon& polygon, std::span<const Vec3<double>> positions,
                PolygonTriangles& triangles) {
  if (polygon.count == 3) {
    triangles[0] = {0, 1, 2};
    return 1;
  }
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto n = static_cast<std::size_t>(polygon.count);
  const bool isFlat = isWithinFace(polygon);
  const auto diagonal = [&](std::size_t i, std::size_t j) {
    if (j - i == 1 || (i == 0 && j == n - 1)) return 0.0;
    const unsigned common = facesOf(polygon.corners[i]) & facesOf(polygon.corners[j]);
    const auto along = positions[j] - positions[i];
    return common != 0 && !isFlat ? kNever : dot(along, along);
  };
  // Dynamic programming over pieces (Klincsek 1980): the triangle at side (i, j) has its apex at k.
  PieceTable<double> cost{};
  PieceTable<std::uint8_t> apex{};
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      double best = kNever;
      for (std::size_t k = i + 1; k < j; ++k) {
        if (cost[i][k] + cost[k][j] >= best) continue;
        best = cost[i][k] + cost[k][j];
        apex[i][j] = static_cast<std::uint8_t>(k);
      }
      cost[i][j] = best + diagonal(i, j);
    }
  }
  if (cost[0][n - 1] == kNever) return 0;
  std::size_t count = 0;
  std::array<std::array<std::size_t, 2>, CellPolygon::kMost> open{};
  std::size_t pieces = 0;
  open[pieces++] = {0, n - 1};
  while (pieces > 0) {
    const auto [i, j] = open[--pieces];
    if (j - i < 2) continue;
    const auto k = static_cast<std::size_t>(apex[i][j]);
    triangles[count++] = {static_cast<std::uint8_t>(i), apex[i][j], static_cast<std::uint8_t>(j)};
    open[pieces++] = {i, k};
    open[pieces++] = {k, j};
  }
  return static_cast<int>(count);
}

bool needsMiddle(const CellPolygon& polygon) {
  if (polygon.count < 8) return false;
  const std::array<Vec3<double>, CellPolygon::kMost> anywhere{};
  PolygonTriangles triangles;
  return triangulate(polygon, anywhere, triangles) == 0;
}

}  // namespace cutwater::detail
