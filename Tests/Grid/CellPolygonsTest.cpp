#include <Cutwater/Grid/Detail/CellPolygons.hpp>

#include <bit>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace cutwater::detail {
namespace {

/// Calls test(inside, joined) for all signs of corners, and all that ambiguous faces may say.
template <typename Test>
void forEachCell(Test&& test) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    const unsigned ambiguous = ambiguousFaces(inside);
    unsigned joined = ambiguous;
    for (;; joined = (joined - 1) & ambiguous) {
      test(inside, joined);
      if (joined == 0) break;
    }
  }
}

std::vector<CellPolygon> surfaceIn(unsigned inside, unsigned joined) {
  std::array<CellPolygon, 4> polygons;
  const int count = surfacePolygons(inside, joined, polygons);
  return {polygons.begin(), polygons.begin() + count};
}

std::vector<CellPolygon> facesIn(unsigned inside, unsigned joined, int face) {
  std::array<CellPolygon, 2> polygons;
  const int count = facePolygons(inside, joined, face, polygons);
  return {polygons.begin(), polygons.begin() + count};
}

Vec3<double> positionOf(int corner) {
  const auto [axis, lower] = corner < 12 ? cubeEdge(corner) : CubeEdge{-1, corner - 12};
  Vec3<double> result(lower & 1, (lower >> 1) & 1, lower >> 2);
  if (axis >= 0) result[axis] = 0.5;
  return result;
}

/// Faces of the cube that both points lie in.
bool shareFace(const Vec3<double>& a, const Vec3<double>& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] == b[axis] && a[axis] != 0.5) return true;
  }
  return false;
}

std::map<std::pair<int, int>, int> sidesOf(const std::vector<CellPolygon>& polygons) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& polygon : polygons) {
    for (int i = 0; i < polygon.count; ++i) {
      const auto corner = [&](int n) { return polygon.corners[static_cast<std::size_t>(n)]; };
      ++sides[{corner(i), corner((i + 1) % polygon.count)}];
    }
  }
  return sides;
}

double volumeWithin(const std::vector<CellPolygon>& polygons) {
  double sum = 0;
  for (const auto& polygon : polygons) {
    const auto at = [&](int n) { return positionOf(polygon.corners[static_cast<std::size_t>(n)]); };
    for (int i = 1; i + 1 < polygon.count; ++i) sum += dot(at(0), cross(at(i), at(i + 1))) / 6;
  }
  return sum;
}

TEST(CellPolygons, EdgesAndFacesAreThoseOfACube) {
  std::set<int> edges;
  for (int edge = 0; edge < 12; ++edge) {
    const auto [axis, corner] = cubeEdge(edge);
    EXPECT_EQ((corner >> axis) & 1, 0);
    EXPECT_EQ(cubeEdgeBetween(corner, corner | (1 << axis)), edge);
    EXPECT_EQ(cubeEdgeBetween(corner | (1 << axis), corner), edge);
    edges.insert(8 * axis + corner);
  }
  EXPECT_EQ(edges.size(), 12U);
  for (int face = 0; face < 6; ++face) {
    const auto corners = cubeFace(face);
    const auto at = [&](std::size_t n) { return positionOf(12 + corners[n]); };
    const auto normal = cross(at(1) - at(0), at(2) - at(1));
    Vec3<double> expected{};
    expected[face / 2] = (face & 1) != 0 ? 1 : -1;
    EXPECT_EQ(normal, expected) << face;
    EXPECT_EQ(at(0)[face / 2], face & 1);
  }
}

TEST(CellPolygons, SurfaceAndFacesTogetherAreClosed) {
  forEachCell([](unsigned inside, unsigned joined) {
    auto all = surfaceIn(inside, joined);
    for (int face = 0; face < 6; ++face) {
      const auto flat = facesIn(inside, joined, face);
      all.insert(all.end(), flat.begin(), flat.end());
    }
    const auto sides = sidesOf(all);
    for (const auto& [side, count] : sides) {
      EXPECT_EQ(count, 1) << inside << " " << joined;
      EXPECT_TRUE(sides.contains({side.second, side.first})) << inside << " " << joined;
    }
    // All normals look out: the solid in the cube has a volume, that grows with its corners.
    const double volume = volumeWithin(all);
    if (inside == 0) {
      EXPECT_EQ(volume, 0);
    } else {
      EXPECT_GT(volume, 0) << inside << " " << joined;
    }
    if (inside == 255) {
      EXPECT_DOUBLE_EQ(volume, 1);
    } else {
      EXPECT_LT(volume, 1) << inside << " " << joined;
    }
  });
}

TEST(CellPolygons, EveryCutEdgeIsInOnePolygon) {
  forEachCell([](unsigned inside, unsigned joined) {
    std::multiset<int> used;
    for (const auto& polygon : surfaceIn(inside, joined)) {
      EXPECT_GE(polygon.count, 3);
      used.insert(polygon.corners.begin(), polygon.corners.begin() + polygon.count);
    }
    for (int edge = 0; edge < 12; ++edge) {
      const auto [axis, corner] = cubeEdge(edge);
      const bool a = ((inside >> static_cast<unsigned>(corner)) & 1U) != 0;
      const bool b = ((inside >> static_cast<unsigned>(corner | (1 << axis))) & 1U) != 0;
      EXPECT_EQ(used.count(edge), a != b ? 1U : 0U) << inside << " " << joined << " " << edge;
    }
  });
}

TEST(CellPolygons, JoinedFacesJoinTheirInsideCorners) {
  // Two opposite corners of the lower face: a polygon each, or one around both.
  const unsigned inside = 0b1001;
  ASSERT_EQ(ambiguousFaces(inside), 1U << 4U);
  EXPECT_EQ(surfaceIn(inside, 0).size(), 2U);
  EXPECT_EQ(surfaceIn(inside, 1U << 4U).size(), 1U);
  EXPECT_EQ(facesIn(inside, 0, 4).size(), 2U);
  EXPECT_EQ(facesIn(inside, 1U << 4U, 4).size(), 1U);
}

/// The triangles of a polygon, and whether they are a disc on its corners with no diagonal in a
/// face.
void expectTriangles(const CellPolygon& polygon, const PolygonTriangles& triangles, int count) {
  ASSERT_EQ(count, polygon.count - 2);
  std::map<std::pair<int, int>, int> sides;
  for (std::size_t t = 0; t < static_cast<std::size_t>(count); ++t) {
    for (std::size_t s = 0; s < 3; ++s) ++sides[{triangles[t][s], triangles[t][(s + 1) % 3]}];
  }
  for (const auto& [side, times] : sides) {
    const auto [a, b] = side;
    EXPECT_EQ(times, 1);
    if ((a + 1) % polygon.count == b) continue;
    EXPECT_TRUE(sides.contains({b, a}));
    EXPECT_FALSE(shareFace(positionOf(polygon.corners[static_cast<std::size_t>(a)]),
                           positionOf(polygon.corners[static_cast<std::size_t>(b)])));
  }
  for (int i = 0; i < polygon.count; ++i) EXPECT_TRUE(sides.contains({i, (i + 1) % polygon.count}));
}

TEST(CellPolygons, TrianglesHaveNoDiagonalInAFace) {
  int withMiddle = 0;
  int without = 0;
  forEachCell([&](unsigned inside, unsigned joined) {
    for (const auto& polygon : surfaceIn(inside, joined)) {
      std::array<Vec3<double>, CellPolygon::kMost> positions;
      for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
        positions[i] = positionOf(polygon.corners[i]);
      }
      PolygonTriangles triangles{};
      const int count = triangulate(polygon, positions, triangles);
      EXPECT_EQ(count == 0, needsMiddle(polygon)) << inside << " " << joined;
      EXPECT_TRUE(count > 0 || joined != 0) << inside;  // only where faces are ambiguous
      ++(count == 0 ? withMiddle : without);
      if (count > 0) expectTriangles(polygon, triangles, count);
    }
  });
  EXPECT_EQ(withMiddle, 116);
  EXPECT_EQ(without, 910);
}

TEST(CellPolygons, TheShortestDiagonalsAreTaken) {
  // The lower half of the cube: a square of cut edges, drawn out along one diagonal.
  const auto polygons = surfaceIn(0b00001111, 0);
  ASSERT_EQ(polygons.size(), 1U);
  ASSERT_EQ(polygons[0].count, 4);
  for (const bool isFirstShort : {true, false}) {
    std::array<Vec3<double>, 4> positions;
    for (std::size_t i = 0; i < 4; ++i) {
      positions[i] = positionOf(polygons[0].corners[i]);
      if ((i % 2 == 0) != isFirstShort) positions[i].z = i < 2 ? 0.9 : 0.1;
    }
    PolygonTriangles triangles{};
    ASSERT_EQ(triangulate(polygons[0], positions, triangles), 2);
    std::map<int, int> used;
    for (std::size_t t = 0; t < 2; ++t) {
      for (const auto corner : triangles[t]) ++used[corner];
    }
    EXPECT_EQ(used[0], isFirstShort ? 2 : 1);
    EXPECT_EQ(used[1], isFirstShort ? 1 : 2);
  }
}

}  // namespace
}  // namespace cutwater::detail
