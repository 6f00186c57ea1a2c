#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PolyMesh.hpp>

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

/// Two tetrahedra on one triangle.
FluidMesh twoTetrahedra() {
  FluidMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1.5}};
  const auto add = [&](std::initializer_list<std::uint32_t> corners, std::uint32_t owner) {
    mesh.faces.corners.insert(mesh.faces.corners.end(), corners);
    mesh.faces.first.push_back(mesh.faces.corners.size());
    mesh.faces.owner.push_back(owner);
  };
  add({0, 2, 1}, 0);
  mesh.faces.neighbour = {1};
  add({0, 1, 3}, 0);
  add({1, 2, 3}, 0);
  add({2, 0, 3}, 0);
  add({1, 0, 4}, 1);
  add({2, 1, 4}, 1);
  add({0, 2, 4}, 1);
  mesh.patches = {{"hull {a}", FluidMesh::PatchKind::Wall, 1, 2},
                  {"hull__a_", FluidMesh::PatchKind::Open, 3, 1},
                  {"xMin", FluidMesh::PatchKind::Side, 4, 3}};
  mesh.cells = {.leaf = {0, 1}, .volume = {1.0 / 6, 0.25}, .region = {0, 0}};
  mesh.regions = {1.0 / 6 + 0.25};
  return mesh;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What follows the header of a file.
std::string listOf(const std::filesystem::path& file) {
  const auto text = contentOf(file);
  return text.substr(text.find("}\n\n") + 3);
}

TEST(PolyMeshTest, WritesText) {
  const TemporaryFolder folder;
  writePolyMesh(folder.path(), twoTetrahedra());
  const auto mesh = folder.path() / "constant" / "polyMesh";
  EXPECT_EQ(listOf(mesh / "points"), "5\n(\n(0 0 0)\n(1 0 0)\n(0 1 0)\n(0 0 1)\n(0 0 -1.5)\n)\n");
  EXPECT_EQ(listOf(mesh / "faces"),
            "7\n(\n3(0 2 1)\n3(0 1 3)\n3(1 2 3)\n3(2 0 3)\n3(1 0 4)\n3(2 1 4)\n3(0 2 4)\n)\n");
  EXPECT_EQ(listOf(mesh / "owner"), "7\n(\n0\n0\n0\n0\n1\n1\n1\n)\n");
  EXPECT_EQ(listOf(mesh / "neighbour"), "1\n(\n1\n)\n");
  EXPECT_NE(contentOf(mesh / "owner").find("nPoints:5  nCells:2  nFaces:7  nInternalFaces:1"),
            std::string::npos);
  const auto boundary = listOf(mesh / "boundary");
  const auto has = [&](const char* text) { return boundary.find(text) != std::string::npos; };
  EXPECT_TRUE(has("hull__a_\n    {\n        type            wall;")) << boundary;
  EXPECT_TRUE(has("hull__a__1\n    {\n        type            patch;")) << boundary;
  EXPECT_TRUE(has("nFaces          3;\n        startFace       4;")) << boundary;
  EXPECT_FALSE(exists(mesh / "cellZones"));
}

TEST(PolyMeshTest, WritesNumbersAsInMemory) {
  const TemporaryFolder folder;
  auto two = twoTetrahedra();
  two.cells.region = {1, 0};
  two.regions = {0.25, 1.0 / 6};
  writePolyMesh(folder.path(), two, {.binary = true});
  const auto mesh = folder.path() / "constant" / "polyMesh";
  const auto points = listOf(mesh / "points");
  ASSERT_EQ(points.size(), std::strlen("5\n()\n") + 15 * sizeof(double));
  double last = 0;
  std::memcpy(&last, points.data() + 3 + 14 * sizeof(double), sizeof(double));
  EXPECT_EQ(last, -1.5);
  const auto faces = listOf(mesh / "faces");
  EXPECT_EQ(faces.size(), std::strlen("8\n()\n21\n()\n") + (8 + 21) * sizeof(std::int32_t));
  EXPECT_NE(contentOf(mesh / "faces").find("faceCompactList"), std::string::npos);
  EXPECT_NE(listOf(mesh / "cellZones").find("region1"), std::string::npos);
  writePolyMesh(folder.path(), twoTetrahedra());  // of one region
  EXPECT_FALSE(exists(mesh / "cellZones"));
}

TEST(PolyMeshTest, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "constant") << "a file";
  EXPECT_THROW(writePolyMesh(folder.path(), twoTetrahedra()), Error);
}

}  // namespace
}  // namespace cutwater::test
