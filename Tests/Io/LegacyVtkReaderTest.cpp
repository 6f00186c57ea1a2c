#include "PointFile.hpp"

namespace cutwater::test {
namespace {

class LegacyVtkReaderTest : public PointFile {
 protected:
  static std::string start(const std::string& dataset, const std::string& encoding = "ASCII",
                           const std::string& version = "3.0") {
    return "# vtk DataFile Version " + version + "\na title\n" + encoding + "\nDATASET " + dataset +
           "\n";
  }
  static constexpr const char* kPoints = "POINTS 5 double\n0 0 0 1 0 0\n0 1 0\n0 0 1 1 1 1\n";
  static constexpr const char* kCells = "CELLS 2 9\n4 0 1 2 3\n3 1 2 4\nCELL_TYPES 2\n10 5\n";
  static constexpr const char* kData =
      "CELL_DATA 2\nSCALARS q int\nLOOKUP_TABLE default\n-7 8\n"
      "POINT_DATA 5\nSCALARS two float 2\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9 0.1\n"
      "VECTORS U double\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 nan\n"
      "FIELD FieldData 1\na%20b%25 1 5 unsigned_char\n0 1 2 3 255\n"
      "METADATA\nINFORMATION 0\n\nTEXTURE_COORDINATES t 2 float\n1 2 3 4 5 6 7 8 9 10\n"
      "COLOR_SCALARS c 1\n0 .25 .5 .75 1\nLOOKUP_TABLE mine 1\n0 0 0 1\n";
  const std::string grid = start("UNSTRUCTURED_GRID") + kPoints + kCells;

  static void expectGrid(const PointData& data) {
    EXPECT_EQ(data.mesh, DataMesh::Unstructured);
    EXPECT_EQ(data.points,
              (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}));
    EXPECT_EQ(data.cells, (DataCells{.kinds = {10, 5},
                                     .offsets = {0, 4, 7},
                                     .corners = {0, 1, 2, 3, 1, 2, 4},
                                     .faces = {},
                                     .faceEnds = {}}));
  }
};

TEST_F(LegacyVtkReaderTest, ReadsAnUnstructuredGridWithItsArrays) {
  const auto data = read(grid + kData);
  expectGrid(data);
  EXPECT_FALSE(data.singlePrecision);
  EXPECT_EQ(data.cellArrays, (std::vector<DataArray>{{"q", std::vector<std::int32_t>{-7, 8}}}));
  ASSERT_EQ(data.pointArrays.size(), 5U);
  EXPECT_EQ(data.pointArrays[0],
            (DataArray{"two", std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9, 0.1F}, 2}));
  EXPECT_EQ(data.pointArrays[1].name, "U");
  EXPECT_EQ(data.pointArrays[1].components, 3U);
  EXPECT_EQ(numbersOf(data.pointArrays[1])[13], 14);
  EXPECT_EQ(data.pointArrays[2], (DataArray{"a b%", std::vector<std::uint8_t>{0, 1, 2, 3, 255}}));
  EXPECT_EQ(data.pointArrays[3].components, 2U);
  EXPECT_EQ(data.pointArrays[4], (DataArray{"c", std::vector<float>{0, .25F, .5F, .75F, 1}}));
  EXPECT_EQ(data.notes.size(), 1U);
}

TEST_F(LegacyVtkReaderTest, ReadsBinaryOfVersion3And5) {
  constexpr auto kBig = std::endian::big;
  const std::string points = "POINTS 5 float\n" +
                             bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, kBig) +
                             "\n";
  const std::string kinds = "CELL_TYPES 2\n" + bytesOf<std::int32_t>({10, 5}, kBig) + "\n";
  const std::string data = "POINT_DATA 5\nSCALARS p double 1\nLOOKUP_TABLE default\n" +
                           bytesOf<double>({1, 2, 3, 4, 0.1}, kBig) + "\nCELL_DATA 2\nFIELD F 1\n" +
                           "id 1 2 vtktypeint64\n" + bytesOf<std::int64_t>({-1, 1LL << 40}, kBig) +
                           "\n";
  const auto old =
      read(start("UNSTRUCTURED_GRID", "BINARY") + points + "CELLS 2 9\n" +
           bytesOf<std::int32_t>({4, 0, 1, 2, 3, 3, 1, 2, 4}, kBig) + "\n" + kinds + data);
  expectGrid(old);
  EXPECT_TRUE(old.singlePrecision);
  EXPECT_EQ(old.pointArrays, (std::vector<DataArray>{{"p", std::vector<double>{1, 2, 3, 4, 0.1}}}));
  EXPECT_EQ(old.cellArrays,
            (std::vector<DataArray>{{"id", std::vector<std::int64_t>{-1, 1LL << 40}}}));
  const auto recent = read(
      start("UNSTRUCTURED_GRID", "BINARY", "5.1") + points + "CELLS 3 7\nOFFSETS vtktypeint64\n" +
      bytesOf<std::int64_t>({0, 4, 7}, kBig) + "\nCONNECTIVITY vtktypeint64\n" +
      bytesOf<std::int64_t>({0, 1, 2, 3, 1, 2, 4}, kBig) + "\n" + kinds + data);
  expectSameData(recent, old);
}

TEST_F(LegacyVtkReaderTest, PutsThePartsOfPolyDataInVtksOrder) {
  const auto data = read(start("POLYDATA") + kPoints +
                         "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOLYGONS 1 4\n3 0 1 2\nLINES 1 3\n2 3 "
                         "4\nVERTICES 2 4\n1 4 1 0\nCELL_DATA 5\nSCALARS i short\nLOOKUP_TABLE "
                         "default\n0 1 2 3 4\n");
  EXPECT_EQ(data.mesh, DataMesh::PolyData);
  EXPECT_EQ(data.cells, (DataCells{.kinds = {2, 2, 4, 7, 6},
                                   .offsets = {0, 1, 2, 4, 7, 11},
                                   .corners = {4, 0, 3, 4, 0, 1, 2, 0, 1, 2, 3},
                                   .faces = {},
                                   .faceEnds = {}}));
  expectSameData(again(data, "again.vtk"), data);
}

TEST_F(LegacyVtkReaderTest, WhatIsWrittenReadsBackToTheBit) {
  auto data = read(grid + kData);
  std::get<std::vector<double>>(data.pointArrays[1].numbers)[14] = -0.0;  // NaN equals nothing
  data.fieldArrays = {{"TIME", std::vector<double>{0.25}}};
  data.pointArrays.push_back({"i64", std::vector<std::int64_t>{1, -2, 3, -4, INT64_MIN}});
  expectSameData(again(data, "again.vtk"), data);
}

TEST_F(LegacyVtkReaderTest, RefusesWhatDoesNotFitTogether) {
  const auto with = [&](const std::string& from, const std::string& to) {
    auto text = grid + kData;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return refusal(text.replace(at, from.size(), to));
  };
  EXPECT_EQ(with("UNSTRUCTURED_GRID", "STRUCTURED_GRID"),
            "line 4: expected POLYDATA or UNSTRUCTURED_GRID, found \"STRUCTURED_GRID\"");
  EXPECT_EQ(with("1 1 1\n", "1 1 inf\n"), "line 8: a coordinate is not finite");
  EXPECT_EQ(with("1 2 4", "1 2 5"), "line 11: index 5 is out of range: the file has 5 points");
  EXPECT_EQ(with("1 2 4", "1 2 -1"), "line 11: index -1 is out of range");
  EXPECT_EQ(with("CELL_TYPES 2\n10 5", "CELL_TYPES 1\n10"),
            "line 35: 1 kinds of cells for 2 cells");
  EXPECT_EQ(with("10 5\n", "10 256\n"), "line 13: there is no kind of cells 256");
  EXPECT_EQ(with("10 5\n", "42 5\n"), "line 13: polyhedra are read from .vtu only");
  EXPECT_EQ(with("CELL_DATA 2", "CELL_DATA 3"), "line 14: data for 3 of 2");
  EXPECT_EQ(with("POINT_DATA 5", "POINT_DATA 4"), "line 18: data for 4 of 5");
  EXPECT_EQ(with("1 5 unsigned_char", "1 4 unsigned_char"),
            "line 25: the array \"a%20b%25\" has 4 rows for 5");
  EXPECT_EQ(with("2 3 255", "2 3 256"), "line 26: 256 is out of range");
  EXPECT_EQ(with("VECTORS U", "VECTORS two"), "line 22: a second array named \"two\"");
  EXPECT_EQ(with("VECTORS U double", "VECTORS U bit"), "line 22: unknown number type \"bit\"");
  EXPECT_EQ(with("CELLS 2 9", "POLYGONS 2 9"), "line 9: \"POLYGONS\" in another kind of data set");
  EXPECT_EQ(with("CELL_DATA 2\n", ""), "line 14: \"SCALARS\" before POINT_DATA or CELL_DATA");
  EXPECT_EQ(with("CELL_DATA", "DATA"), "line 14: unknown keyword \"DATA\"");
  EXPECT_EQ(with("t 2 float", "t 0 float"), "line 30: an array of 0 components");
  EXPECT_EQ(refusal(start("POLYDATA")), "line 4: the file ends without POINTS");
}

TEST_F(LegacyVtkReaderTest, RefusesCountsThatTheFileHasNoRoomFor) {
  EXPECT_NE(refusal(start("POLYDATA") + "POINTS 1000000000 float\n0 0 0\n").find("promises"),
            std::string::npos);
  EXPECT_NE(refusal(grid + "POINT_DATA 5\nCOLOR_SCALARS a 100000\n1 2 3\n").find("promises"),
            std::string::npos);
  EXPECT_NE(refusal(grid + "POINT_DATA 5\nFIELD F 1\na 9000000000000000000 5 int\n1 2\n")
                .find("promises"),
            std::string::npos);
  EXPECT_NE(
      refusal(start("UNSTRUCTURED_GRID") + kPoints + "CELL_TYPES 99999999\n1\n").find("promises"),
      std::string::npos);
  const auto whole = grid + kData;
  const auto points = grid.find("CELLS");
  for (std::size_t size = 0; size + 12 < whole.size(); ++size) {
    const auto message = refusal(whole.substr(0, size));
    // What is left may be whole: it ends behind an array.
    const bool mayBeWhole = size + 1 == points || size == points || size + 1 >= grid.size();
    EXPECT_TRUE(message != "nothing" || mayBeWhole) << size;
  }
}

TEST_F(LegacyVtkReaderTest, RefusesToWriteWhatItWouldNotRead) {
  auto data = read(grid);
  data.cells.kinds[0] = 42;
  EXPECT_NE(writeRefusal(data, "a.vtk").find("polyhedra"), std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
