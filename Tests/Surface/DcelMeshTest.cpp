#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <numbers>
#include <optional>

#include "Support/CpuTime.hpp"
#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DcelMeshTest : public ::testing::Test {};
TYPED_TEST_SUITE(DcelMeshTest, Precisions);

template <typename Range>
auto collected(const Range& range) {
  std::vector<std::remove_cvref_t<decltype(*range.begin())>> result;
  for (const auto id : range) result.push_back(id);
  return result;
}

/// What holds for every mesh, whatever the soup.
template <typename T>
void expectConsistent(const DcelMesh<T>& mesh) {
  std::size_t leaving = 0;
  for (const VertexId v : mesh.vertices()) {
    leaving += mesh.outgoing(v).size();
    for (const HalfEdgeId e : mesh.outgoing(v)) EXPECT_EQ(mesh.origin(e), v);
  }
  EXPECT_EQ(leaving, mesh.halfEdges().size());
  for (const FaceId face : mesh.faces()) {
    for (const HalfEdgeId e : mesh.halfEdges(face)) EXPECT_EQ(mesh.face(e), face);
  }
  for (const HalfEdgeId e : mesh.halfEdges()) {
    EXPECT_EQ(mesh.prev(mesh.next(e)), e);
    EXPECT_EQ(mesh.next(mesh.prev(e)), e);
    EXPECT_EQ(mesh.target(e), mesh.origin(mesh.next(e)));
    if (!mesh.hasTwin(e)) continue;
    EXPECT_NE(mesh.twin(e), e);
    EXPECT_EQ(mesh.twin(mesh.twin(e)), e);
    EXPECT_EQ(mesh.origin(mesh.twin(e)), mesh.target(e));
    EXPECT_EQ(mesh.target(mesh.twin(e)), mesh.origin(e));
  }
}

/// By the definition, in quadratic time: one half-edge each way, and the ends differ.
template <typename T>
void expectTwinsByDefinition(const DcelMesh<T>& mesh) {
  for (const HalfEdgeId e : mesh.halfEdges()) {
    std::vector<HalfEdgeId> same;
    std::vector<HalfEdgeId> opposite;
    for (const HalfEdgeId f : mesh.halfEdges()) {
      if (mesh.origin(f) == mesh.origin(e) && mesh.target(f) == mesh.target(e)) same.push_back(f);
      if (mesh.origin(f) == mesh.target(e) && mesh.target(f) == mesh.origin(e)) {
        opposite.push_back(f);
      }
    }
    const bool paired =
        same.size() == 1 && opposite.size() == 1 && mesh.origin(e) != mesh.target(e);
    EXPECT_EQ(mesh.twin(e), paired ? opposite[0] : kNoHalfEdge);
  }
}

TYPED_TEST(DcelMeshTest, ConnectsACubeOfQuads) {
  const DcelMesh<TypeParam> mesh(cube());
  expectConsistent(mesh);
  EXPECT_EQ(mesh.vertices().size(), 8U);
  EXPECT_EQ(mesh.halfEdges().size(), 24U);
  EXPECT_EQ(mesh.faces().size(), 6U);
  for (const HalfEdgeId e : mesh.halfEdges()) EXPECT_TRUE(mesh.hasTwin(e));
  for (const VertexId v : mesh.vertices()) EXPECT_EQ(mesh.outgoing(v).size(), 3U);

  // Face 0 is 0, 4, 6, 2 at x = 0.
  const FaceId left{0};
  EXPECT_EQ(collected(mesh.halfEdges(left)),
            (std::vector{HalfEdgeId{0}, HalfEdgeId{1}, HalfEdgeId{2}, HalfEdgeId{3}}));
  EXPECT_EQ(collected(mesh.vertices(left)),
            (std::vector{VertexId{0}, VertexId{4}, VertexId{6}, VertexId{2}}));
  EXPECT_EQ(mesh.next(HalfEdgeId{3}), HalfEdgeId{0});
  EXPECT_EQ(mesh.prev(HalfEdgeId{0}), HalfEdgeId{3});
  EXPECT_EQ(mesh.target(HalfEdgeId{3}), VertexId{0});
  // Across 0-4, 4-6, 6-2, 2-0: front, top, back, bottom.
  EXPECT_EQ(collected(mesh.neighbours(left)),
            (std::vector{FaceId{2}, FaceId{5}, FaceId{3}, FaceId{4}}));
  EXPECT_EQ(collected(mesh.faces(VertexId{0})), (std::vector{FaceId{0}, FaceId{2}, FaceId{4}}));
  EXPECT_EQ(mesh.triangles(left).size(), 2U);
}

TYPED_TEST(DcelMeshTest, PairsTwinsByTheirDefinition) {
  const PolygonSoup cubes = together(cube(), cube());
  for (const PolygonSoup& soup :
       {tetrahedron(), cube(), lPrism(), flipped(cube(), 2), merged(cubes, 15, 0),
        merged(merged(cubes, 15, 0), 14, 1), together(cube(), tetrahedron()), star(7),
        makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}, {{0},
                                                                           {0, 1},
                                                                           {0, 0},
                                                                           {0, 0, 1},
                                                                           {0, 1, 2},
                                                                           {2, 1, 0},
                                                                           {1, 2, 3},
                                                                           {1, 2, 3},
                                                                           {2, 3, 2},
                                                                           {3, 1, 3, 1}})}) {
    const DcelMesh<TypeParam> mesh(soup);
    expectConsistent(mesh);
    expectTwinsByDefinition(mesh);
  }
}

TYPED_TEST(DcelMeshTest, SkipsMissingNeighbours) {
  PolygonSoup open = cube();
  open.patches.pop_back();
  open.offsets.pop_back();
  open.corners.resize(20);
  const DcelMesh<TypeParam> mesh(open);
  EXPECT_EQ(collected(mesh.neighbours(FaceId{0})),
            (std::vector{FaceId{2}, FaceId{3}, FaceId{4}}));  // all but the lid, face 5
  EXPECT_EQ(collected(mesh.faces(VertexId{4})), (std::vector{FaceId{0}, FaceId{2}}));
}

TYPED_TEST(DcelMeshTest, VisitsEveryEdgeOnceWithAllItsFaces) {
  // Two cubes that share the edge 0-1 (point 14 of the second is moved there, and 15).
  const DcelMesh<TypeParam> mesh(merged(merged(together(cube(), cube()), 14, 0), 15, 1));
  std::size_t edges = 0;
  std::size_t uses = 0;
  mesh.visitEdges([&](const auto& edge) {
    ++edges;
    uses += edge.halfEdges.size();
    EXPECT_LT(edge.lower, edge.upper);
    const bool shared = edge.lower == VertexId{0} && edge.upper == VertexId{1};
    EXPECT_EQ(edge.halfEdges.size(), shared ? 4U : 2U);
  });
  EXPECT_EQ(edges, 23U);
  EXPECT_EQ(uses, 48U);
}

TYPED_TEST(DcelMeshTest, RefusesImpossibleSoups) {
  using T = TypeParam;
  PolygonSoup soup = tetrahedron();
  soup.corners[3] = 4;
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup = tetrahedron();
  soup.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup.points[2].y = 1e200;  // no float, and no double square
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup = tetrahedron();
  soup.offsets[1] = 0;  // no corners
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup = tetrahedron();
  soup.offsets[1] = 7;  // offsets that fall
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup.offsets[1] = 700;  // and that leave the array
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup = tetrahedron();
  soup.corners.pop_back();
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  soup = tetrahedron();
  soup.offsets.clear();
  EXPECT_THROW(DcelMesh<T>{soup}, Error);
  EXPECT_EQ(DcelMesh<T>(PolygonSoup{}).faces().size(), 0U);
}

TYPED_TEST(DcelMeshTest, MeasuresFaces) {
  using T = TypeParam;
  const DcelMesh<T> ell(lPrism(2));
  const FaceId bottom{6};
  const FaceId top{7};
  EXPECT_EQ(ell.normal(bottom), (Vec3<T>{0, 0, -1}));
  EXPECT_EQ(ell.normal(top), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(ell.area(top), T(3));
  // Squares at (1/2, 1/2), (3/2, 1/2), (1/2, 3/2).
  EXPECT_LE(length(ell.centroid(top) - Vec3<T>{T(5) / 6, T(5) / 6, 2}), tolerance<T>(1));
  EXPECT_NEAR(ell.totalArea(), 3 + 3 + 8 * 2, 1e-14);
  EXPECT_NEAR(ell.signedVolume(), 6, 1e-14);

  const DcelMesh<T> flat(makeSoup({{1, 1, 1}, {2, 2, 2}, {6, 6, 6}}, {{0, 1, 2}, {0, 1}}));
  EXPECT_EQ(flat.normal(FaceId{0}), Vec3<T>{});
  EXPECT_EQ(flat.area(FaceId{0}), T(0));
  EXPECT_EQ(flat.centroid(FaceId{0}), (Vec3<T>{3, 3, 3}));
  EXPECT_EQ(flat.centroid(FaceId{1}), (Vec3<T>{1.5, 1.5, 1.5}));
  EXPECT_EQ(flat.triangles(FaceId{1}).size(), 0U);
}

TYPED_TEST(DcelMeshTest, MeasuresSolidsFarFromTheOrigin) {
  using T = TypeParam;
  // 2^20 sizes away; the coordinates stay exact (in float, with sizes of a few eighths).
  const Vec3<double> offset{1 << 20, -(1 << 20), 1 << 20};
  const double scale = std::is_same_v<T, float> ? 1 : 0.125;
  const auto away = [&](const Vec3<double>& p) { return scale * p + offset; };
  const DcelMesh<T> ell(withPoints(lPrism(2), away));
  EXPECT_EQ(ell.signedVolume(), 6 * scale * scale * scale);
  EXPECT_EQ(ell.totalArea(), 22 * scale * scale);
  EXPECT_EQ(ell.centroid(FaceId{0}), static_cast<Vec3<T>>(away({1, 0, 1})));

  const Vec3<double> million{1e6, 1e6, 1e6};
  const PolygonSoup ball =
      withPoints(tessellation::icosphere(1, 3), [&](const auto& p) { return p + million; });
  const DcelMesh<double> far(ball);
  const DcelMesh<double> near(withPoints(ball, [&](const auto& p) { return p - million; }));
  EXPECT_NEAR(far.signedVolume(), near.signedVolume(), 1e-14);  // that shift was exact
}

TYPED_TEST(DcelMeshTest, MeasuresTheSurfaceAndNotPointsOfNoFace) {
  using T = TypeParam;
  auto soup = cube();
  soup.points.emplace_back(1e18, -1e18, 1e18);
  const DcelMesh<T> mesh(soup);
  EXPECT_EQ(mesh.measure(), (SurfaceMeasure{6, 1}));
  EXPECT_EQ(mesh.boundingBox(), (Box<T>{{0, 0, 0}, {1, 1, 1}}));
}

TYPED_TEST(DcelMeshTest, CubeCornersHaveDiagonalPseudonormals) {
  using T = TypeParam;
  // Each side's angle at a corner is 90 degrees however the quads are cut.
  const DcelMesh<T> mesh(cube());
  for (const VertexId v : mesh.vertices()) {
    const Vec3<T> outwards = normalized(mesh.position(v) - Vec3<T>{0.5, 0.5, 0.5});
    EXPECT_LE(length(mesh.pseudonormal(v) - outwards), tolerance<T>(1));
  }
  for (const HalfEdgeId e : mesh.halfEdges()) {
    const Vec3<T> middle = (mesh.position(mesh.origin(e)) + mesh.position(mesh.target(e))) / T(2);
    const Vec3<T> outwards = normalized(middle - Vec3<T>{0.5, 0.5, 0.5});
    EXPECT_LE(length(mesh.pseudonormal(e) - outwards), tolerance<T>(1));
  }
}

TYPED_TEST(DcelMeshTest, ConcaveCornersHaveReflexAngles) {
  using T = TypeParam;
  // Vertex 9 is the notch (1, 1) of the top: 270 degrees of it, 90 of each of two walls.
  const DcelMesh<T> ell(lPrism());
  const Vec3<T> want = normalized(Vec3<T>{1, 1, 3});
  EXPECT_LE(length(ell.pseudonormal(VertexId{9}) - want), tolerance<T>(1));
}

TYPED_TEST(DcelMeshTest, FacesOfNoAreaChangeNoPseudonormal) {
  using T = TypeParam;
  PolygonSoup soup = cube();
  const DcelMesh<T> before(soup);
  soup.points.push_back({0.5, 0, 0});  // in the middle of 0-1
  soup.addPolygon(std::vector<std::uint32_t>{0, 8, 1});
  soup.addPolygon(std::vector<std::uint32_t>{0, 0, 1});
  const DcelMesh<T> after(soup);
  for (const VertexId v : before.vertices()) {
    EXPECT_EQ(before.pseudonormal(v), after.pseudonormal(v));
  }
  EXPECT_EQ(after.pseudonormal(VertexId{8}), Vec3<T>{});
}

TYPED_TEST(DcelMeshTest, PseudonormalsOfASheetPassedTwiceVanish) {
  using T = TypeParam;
  const DcelMesh<T> mesh(
      makeSoup({{0.1, 0.2, 0.3}, {1.1, 0.3, 0.2}, {0.4, 1.7, 0.9}}, {{0, 1, 2}, {1, 0, 2}}));
  for (const VertexId v : mesh.vertices()) EXPECT_EQ(mesh.pseudonormal(v), Vec3<T>{});
  for (const HalfEdgeId e : mesh.halfEdges()) EXPECT_EQ(mesh.pseudonormal(e), Vec3<T>{});
}

TYPED_TEST(DcelMeshTest, PseudonormalsDoNotDependOnTheCut) {
  using T = TypeParam;
  // The sides of a box through any triangulation: a fine box, with quads, triangles, or both.
  const PolygonSoup quads = tessellation::box({0, 0, 0}, {3, 2, 1}, 4);
  const DcelMesh<T> one(quads);
  const DcelMesh<T> other(triangulated(quads));
  for (const VertexId v : one.vertices()) {
    EXPECT_LE(length(one.pseudonormal(v) - other.pseudonormal(v)), tolerance<T>(1));
    EXPECT_NEAR(length(one.pseudonormal(v)), 1, tolerance<T>(1));
  }
}

TYPED_TEST(DcelMeshTest, PseudonormalsSurviveNeedles) {
  using T = TypeParam;
  // A steep cone cut into needles 1e-3 ... 1e-6 as wide as high: at the tip they add up to its
  // axis.
  for (const int n : {1000, 100000}) {
    const DcelMesh<T> cone(tessellation::cone(0.01, 1, n));
    const VertexId tip{static_cast<std::uint32_t>(n)};
    ASSERT_EQ(cone.position(tip), (Vec3<T>{0, 0, 1}));
    const double slack = std::is_same_v<T, float> ? 1e-2 : 1e-9;  // of the rounded positions
    EXPECT_LE(length(cone.pseudonormal(tip) - Vec3<T>{0, 0, 1}), slack);
  }
}

TYPED_TEST(DcelMeshTest, BuildsInLinearTimeAroundOneVertex) {
  std::optional<DcelMesh<TypeParam>> built;
  // About 0.04 s; a sanitizer takes ten times that, a quadratic build minutes.
  EXPECT_LT(cpuSeconds([&] { built.emplace(star(50000)); }), 2);
  const auto& mesh = *built;
  EXPECT_EQ(mesh.outgoing(VertexId{0}).size(), 50000U);
  for (const HalfEdgeId e : mesh.halfEdges()) ASSERT_TRUE(mesh.hasTwin(e));
}

}  // namespace
}  // namespace cutwater::test
