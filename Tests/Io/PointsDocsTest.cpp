#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

TEST(PointsDocsTest, AddsDistancesToAMesh) {
  const TemporaryFolder folder;
  const auto path = folder / "mesh.vtk";
  const auto output = folder / "walls.vtk";
  const Solid<double> solid = Sphere<double>({0, 0, 0}, 1);
  writePointData(path, {.mesh = DataMesh::Unstructured,
                        .points = {{2, 0, 0}, {4, 0, 0}, {0, 0, 0}},
                        .cells = {.kinds = {3, 1}, .offsets = {0, 2, 3}, .corners = {0, 1, 2}}});
  // [DOCS
  auto data = readPointData(path);  // .csv, .npy, .vtk, .vtu, .vtp
  const auto centers = cellCenters(data);
  std::vector<double> distances(centers.size());
  solid.signedDistances(centers, distances);
  data.cellArrays.push_back({"distance", std::move(distances)});
  writePointData(output, data);
  // DOCS]
  EXPECT_EQ(readPointData(output).cellArrays,
            (std::vector<DataArray>{{"distance", std::vector<double>{2, -1}}}));
}

TEST(PointsDocsTest, FindsFirstHits) {
  const Solid<double> solid = Sphere<double>({0, 0, 0}, 1);
  const std::vector<Segment<double>> segments{{{-3, 0, 0}, {3, 0, 0}}, {{-3, 2, 0}, {3, 2, 0}}};
  std::vector<double> lengths(segments.size(), -1);
  // [DOCS
  std::vector<FirstHit<double>> hits(segments.size());
  solid.firstHits(segments, hits);  // a mesh does not look at what is behind the first
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double whole = length(segments[i].end - segments[i].start);
    if (hits[i].found) lengths[i] = whole * hits[i].crossing.parameter;
  }
  const CrossingLists<double> all = solid.crossings(segments);  // of(i): those of segment i
  // DOCS]
  EXPECT_NEAR(lengths[0], 2, 1e-12);
  EXPECT_EQ(lengths[1], -1);
  EXPECT_EQ(all.of(0).size(), 2U);
  EXPECT_EQ(all.of(1).size(), 0U);
}

}  // namespace
}  // namespace cutwater::test
