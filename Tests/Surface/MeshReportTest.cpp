#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <gtest/gtest.h>

#include "Support/CpuTime.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

MeshReport report(const PolygonSoup& soup) {
  return check(DcelMesh<double>(soup));
}

std::size_t defects(const MeshReport& r) {
  return r.boundaryEdges.count + r.nonManifoldEdges.count + r.misorientedEdges.count +
         r.nonManifoldVertices.count + r.unusedVertices.count + r.repeatedCornerFaces.count +
         r.zeroAreaFaces.count + r.duplicateFaces.count + r.oppositeFaces.count;
}

TEST(MeshReport, FindsNothingWrongWithACube) {
  const MeshReport r = report(cube());
  EXPECT_TRUE(r.isClean());
  EXPECT_TRUE(r.isClosed() && r.isOriented() && r.isManifold() && r.isClosedOriented());
  EXPECT_FALSE(r.isInsideOut());
  EXPECT_EQ(defects(r), 0U);
  EXPECT_EQ(r.vertices, 8U);
  EXPECT_EQ(r.edges, 12U);
  EXPECT_EQ(r.faces, 6U);
  EXPECT_EQ(r.triangles, 12U);
  EXPECT_EQ(r.components, 1U);
  EXPECT_EQ(r.eulerCharacteristic, 2);
  EXPECT_EQ(r.genus, 0);
  EXPECT_EQ(r.area, 6);
  EXPECT_EQ(r.volume, 1);
  EXPECT_EQ(r.summary(), "closed, oriented, manifold; 12 triangles, 1 component");
}

TEST(MeshReport, CountsHandles) {
  EXPECT_EQ(report(tessellation::torus(3, 1, 8, 6)).genus, 1);
  const MeshReport two = report(together(tessellation::torus(3, 1, 8, 6), cube()));
  EXPECT_EQ(two.components, 2U);
  EXPECT_EQ(two.eulerCharacteristic, 2);
  EXPECT_EQ(two.genus, 1);
}

TEST(MeshReport, FindsTheRimOfAnOpenBox) {
  PolygonSoup open = cube();
  open.patches.pop_back();
  open.offsets.pop_back();
  open.corners.resize(20);
  const MeshReport r = report(open);
  EXPECT_EQ(r.boundaryEdges.count, 4U);
  EXPECT_EQ(defects(r), 4U);
  for (const auto& place : r.boundaryEdges.examples) {  // the rim is at z = 1: vertices 4 to 7
    EXPECT_GE(place.origin, VertexId{4});
    EXPECT_GE(place.target, VertexId{4});
  }
  EXPECT_FALSE(r.isClosed());
  EXPECT_TRUE(r.isOriented());
  EXPECT_FALSE(r.isClosedOriented());
  EXPECT_FALSE(r.isClean());
  EXPECT_EQ(r.genus, std::nullopt);
  EXPECT_EQ(r.summary(), "not closed, oriented, manifold; 4 open edges; 10 triangles, 1 component");
}

TEST(MeshReport, FindsCubesThatTouch) {
  const PolygonSoup cubes = together(cube(), cube());
  const MeshReport vertex = report(merged(cubes, 15, 0));
  EXPECT_EQ(vertex.nonManifoldVertices.count, 1U);
  EXPECT_EQ(vertex.nonManifoldVertices.examples.front(), VertexId{0});
  EXPECT_EQ(vertex.unusedVertices.count, 1U);
  EXPECT_EQ(defects(vertex), 2U);
  EXPECT_TRUE(vertex.isClosedOriented());
  EXPECT_FALSE(vertex.isManifold());
  EXPECT_EQ(vertex.components, 2U);

  const MeshReport edge = report(merged(merged(cubes, 14, 0), 15, 1));
  EXPECT_EQ(edge.nonManifoldEdges.count, 1U);
  EXPECT_EQ(edge.nonManifoldVertices.count, 2U);
  EXPECT_EQ(edge.boundaryEdges.count, 0U);
  EXPECT_TRUE(edge.isClosed());
  EXPECT_TRUE(edge.isOriented());
  EXPECT_FALSE(edge.isClosedOriented());
  EXPECT_EQ(edge.components, 1U);
}

TEST(MeshReport, FindsAFin) {
  PolygonSoup soup = cube();
  soup.points.push_back({0, 0, 2});
  soup.addPolygon(std::vector<std::uint32_t>{0, 4, 8});
  const MeshReport r = report(soup);
  EXPECT_EQ(r.nonManifoldEdges.count, 1U);
  EXPECT_EQ(r.boundaryEdges.count, 2U);
  EXPECT_EQ(r.oddEdges, 3U);
  EXPECT_FALSE(r.isClosed());
  EXPECT_TRUE(r.isOriented());
}

TEST(MeshReport, FindsAFlippedFace) {
  const MeshReport r = report(flipped(cube(), 2));
  EXPECT_EQ(r.misorientedEdges.count, 4U);
  EXPECT_EQ(defects(r), 4U);  // the vertices are as manifold as before
  EXPECT_TRUE(r.isClosed());
  EXPECT_FALSE(r.isOriented());
  EXPECT_FALSE(r.isClosedOriented());
  EXPECT_TRUE(r.isManifold());
}

TEST(MeshReport, FindsAMoebiusStrip) {
  // Five quads around, the last one joined upside down.
  Polygons quads;
  std::vector<Vec3<double>> points;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const double a = 1.2566370614359172 * i;
    for (const double t : {-0.3, 0.3}) {
      const double r = 1 + t * std::cos(a / 2);
      points.push_back({r * std::cos(a), r * std::sin(a), t * std::sin(a / 2)});
    }
    if (i < 4) quads.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  }
  quads.push_back({8, 1, 0, 9});
  const MeshReport r = report(makeSoup(points, quads));
  EXPECT_EQ(r.misorientedEdges.count, 1U);
  EXPECT_EQ(r.boundaryEdges.count, 10U);
  EXPECT_EQ(r.eulerCharacteristic, 0);
  EXPECT_FALSE(r.isOriented());
}

TEST(MeshReport, FindsDuplicates) {
  PolygonSoup soup = cube();
  soup.addPolygon(std::vector<std::uint32_t>{6, 2, 0, 4});  // face 0, begun elsewhere
  soup.addPolygon(std::vector<std::uint32_t>{7, 3, 1, 5});  // face 1, backwards
  soup.addPolygon(std::vector<std::uint32_t>{1, 5, 7, 3});  // and once more
  soup.addPolygon(std::vector<std::uint32_t>{0, 6, 4, 2});  // the corners of face 0, a bow tie
  const MeshReport r = report(soup);
  EXPECT_EQ(r.duplicateFaces.examples, (std::vector{FaceId{6}}));
  EXPECT_EQ(r.oppositeFaces.examples, (std::vector{FaceId{7}, FaceId{8}}));
}

TEST(MeshReport, FindsDegenerateFaces) {
  PolygonSoup soup = cube();
  soup.points.push_back({0.5, 0, 0});
  soup.addPolygon(std::vector<std::uint32_t>{0, 8, 1});
  soup.addPolygon(std::vector<std::uint32_t>{0, 0, 1});
  soup.addPolygon(std::vector<std::uint32_t>{3});
  soup.addPolygon(std::vector<std::uint32_t>{3, 3, 7, 6, 2});
  const MeshReport r = report(soup);
  EXPECT_EQ(r.repeatedCornerFaces.examples, (std::vector{FaceId{7}, FaceId{8}, FaceId{9}}));
  EXPECT_EQ(r.zeroAreaFaces.examples, (std::vector{FaceId{6}, FaceId{7}, FaceId{8}}));
}

TEST(MeshReport, SmallFacesAreNotDegenerate) {
  for (const double height : {1e-8, 1e-30, 1e-200}) {
    const PolygonSoup soup = makeSoup({{0, 0, 0}, {height, 0, 0}, {0, height, 0}}, {{0, 1, 2}});
    EXPECT_FALSE(report(soup).zeroAreaFaces) << height;
  }
}

TEST(MeshReport, ACornerRepeatedAtOnceOpensNothing) {
  PolygonSoup soup = makeSoup(
      cube().points,
      {{0, 4, 6, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
  const MeshReport r = report(soup);
  EXPECT_TRUE(r.isClosedOriented());
  EXPECT_TRUE(r.isManifold());
  EXPECT_EQ(r.repeatedCornerFaces.count, 1U);
  EXPECT_EQ(r.zeroAreaFaces.count, 0U);
  EXPECT_EQ(r.genus, std::nullopt);
  EXPECT_TRUE(report(triangulated(soup)).isClean());
  EXPECT_TRUE(report(makeSoup(cube().points, {{0, 4, 6, 6, 2}})).isManifold());
}

TEST(MeshReport, FindsAnInsideOutSurface) {
  PolygonSoup soup = cube();
  for (std::size_t i = 0; i < 6; ++i) soup = flipped(soup, i);
  const MeshReport r = report(soup);
  EXPECT_TRUE(r.isInsideOut());
  EXPECT_FALSE(r.isClean());
  EXPECT_EQ(r.volume, -1);
  EXPECT_EQ(r.summary(), "closed, oriented, manifold, inside out; 12 triangles, 1 component");
}

TEST(MeshReport, OfNothingIsNotClosed) {
  const MeshReport r = report(PolygonSoup{});
  EXPECT_FALSE(r.isClosed() || r.isClosedOriented() || r.isClean());
}

TEST(MeshReport, ListsExamplesInATable) {
  PolygonSoup soup = makeSoup(std::vector<Vec3<double>>(12), {});
  soup.points[1] = {1, 0, 0};
  soup.points[2] = {0, 1, 0};
  soup.addPolygon(std::vector<std::uint32_t>{0, 1, 2});
  const MeshReport r = report(soup);
  EXPECT_EQ(r.unusedVertices.count, 9U);
  EXPECT_EQ(r.unusedVertices.examples.size(), 8U);
  EXPECT_EQ(r.eulerCharacteristic, 1);
  const std::string table = r.table();
  EXPECT_NE(table.find("open edges                              3  (vertices 0-1 2-0 1-2)\n"),
            std::string::npos)
      << table;
  EXPECT_NE(
      table.find("unused vertices                         9  (vertices 3 4 5 6 7 8 9 10 ...)"),
      std::string::npos);
  EXPECT_NE(table.find("area                                    0.5\n"), std::string::npos);
  EXPECT_NE(table.find("genus                                   -\n"), std::string::npos);
  EXPECT_EQ(r.summary(),
            "not closed, oriented, manifold; 3 open edges, 9 unused vertices; 1 triangle, "
            "1 component");
}

TEST(MeshReport, IsLinearAroundOneVertexAndForManyDuplicates) {
  PolygonSoup soup = star(30000);
  for (int i = 0; i < 30000; ++i) soup.addPolygon(std::vector<std::uint32_t>{0, 1, 2});
  const DcelMesh<double> mesh(soup);
  MeshReport r;
  EXPECT_LT(cpuSeconds([&] { r = check(mesh); }), 2);  // about 0.03 s
  EXPECT_EQ(r.duplicateFaces.count, 30000U);
}

}  // namespace
}  // namespace cutwater::test
