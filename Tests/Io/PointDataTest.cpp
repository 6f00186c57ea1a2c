#include <cmath>

#include "PointFile.hpp"

namespace cutwater::test {
namespace {

using PointDataTest = PointFile;

/// A tetrahedron and a triangle, with an array of each kind.
PointData sample() {
  return {.mesh = DataMesh::Unstructured,
          .points = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 4}},
          .pointArrays = {{"p", std::vector<double>{1, 2, 3, 4}}},
          .cells = {.kinds = {10, 5}, .offsets = {0, 4, 7}, .corners = {0, 1, 2, 3, 0, 1, 2}},
          .cellArrays = {{"q", std::vector<std::int32_t>{1, 2, 3, 4}, 2}},
          .fieldArrays = {{"TIME", std::vector<float>{7}}}};
}

TEST_F(PointDataTest, CentersAreTheMeanOfCorners) {
  EXPECT_EQ(cellCenters(sample()), (std::vector<Vec3<double>>{{0.75, 0.75, 1}, {1, 1, 0}}));
  auto empty = sample();
  empty.cells = {.kinds = {0}, .offsets = {0, 0}};
  EXPECT_TRUE(std::isnan(cellCenters(empty)[0].x));
  auto huge = sample();
  for (auto& p : huge.points) p = {1e308, 1e308, 1e308};
  EXPECT_EQ(cellCenters(huge)[0], huge.points[0]);
}

TEST_F(PointDataTest, TheContentDecidesTheFormat) {
  auto points = sample();
  points = {.points = points.points, .pointArrays = points.pointArrays};
  writePointData(folder / "a.csv", points);
  std::filesystem::rename(folder / "a.csv", folder / "a.npy");
  EXPECT_EQ(readPointData(folder / "a.npy").points, points.points);
  std::ofstream(path) << "1,2,3\n";
  EXPECT_EQ(readPointData(path).points, (std::vector<Vec3<double>>{{1, 2, 3}}));
  std::ofstream(path) << "1,2\n";
  try {
    static_cast<void>(readPointData(path));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(path.string() + ": line 1: "))
        << error.what();
  }
  EXPECT_NE(refusal("").find("the file is empty"), std::string::npos);
  EXPECT_THROW((void)readPointData(folder / "none.vtu"), Error);
}

TEST_F(PointDataTest, FilesCutWithinTheirFirstWordAreTooShort) {
  for (const std::string content : {"\x93NUM", "# vtk Data", "#"}) {
    EXPECT_NE(refusal(content).find("byte 0: the file is too short"), std::string::npos);
  }
}

TEST_F(PointDataTest, XmlHasTheNamesOfPatchesBesideOtherFields) {
  auto data = sample();
  data.patchNames = {"hull", "<mast>"};
  for (const bool hasOther : {true, false}) {
    if (!hasOther) data.fieldArrays.clear();
    writePointData(folder / "a.vtu", data);
    std::ifstream file(folder / "a.vtu", std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_NE(text.find("104 117 108 108 0\n        60 109 97 115 116 62 0\n"), std::string::npos);
    EXPECT_EQ(text.find("<FieldData"), text.rfind("<FieldData"));  // viewers read one
    const auto again = readPointData(folder / "a.vtu");
    EXPECT_EQ(again.fieldArrays, data.fieldArrays);
    EXPECT_EQ(again.pointArrays, data.pointArrays);
    EXPECT_EQ(again.notes.size(), 1U);  // texts are not read
  }
}

TEST_F(PointDataTest, RefusesFilesBeyondTheLimit) {
  std::ofstream(path) << "1,2,3\n4,5,6\n";
  EXPECT_NO_THROW((void)readPointData(path, {.maxBytes = 12}));
  try {
    static_cast<void>(readPointData(path, {.maxBytes = 11}));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
}

TEST_F(PointDataTest, RefusesDataThatAreNotWhole) {
  const auto refused = [&](auto change, const std::string& part) {
    auto data = sample();
    change(data);
    const auto message = writeRefusal(data, "a.vtk");
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  refused([](PointData& d) { d.pointArrays[0].name = ""; }, "every array needs a name");
  refused([](PointData& d) { d.pointArrays.push_back(d.pointArrays[0]); },
          "two arrays named \"p\"");
  refused([](PointData& d) { d.pointArrays[0].components = 2; }, "4 numbers for 4 rows of 2");
  refused([](PointData& d) { d.cellArrays[0].components = 1; }, "4 numbers for 2 rows of 1");
  refused([](PointData& d) { d.fieldArrays[0].components = 0; }, "rows of 0");
  refused([](PointData& d) { d.cells.corners[6] = 4; }, "the corner 4, and there are 4 points");
  refused([](PointData& d) { d.cells.offsets[1] = 8; }, "offsets");
  refused([](PointData& d) { d.cells.offsets.clear(); }, "offsets");
  refused([](PointData& d) { d.mesh = DataMesh::Points; }, "cells of a mesh of points");
  EXPECT_NE(writeRefusal(sample(), "a.vtz").find("\".vtz\""), std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
