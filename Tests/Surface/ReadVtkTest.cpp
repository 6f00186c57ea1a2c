#include "SurfaceFiles.hpp"

namespace cutwater::test {
namespace {

std::string start(const std::string& version, const std::string& encoding) {
  return "# vtk DataFile Version " + version + "\na title of any kind\n" + encoding +
         "\nDATASET POLYDATA\n";
}
const std::string kFourPoints = "POINTS 4 float\n0 0 0 1 0 0\n0 1 0\n0 0 1\n";  // lines 5 to 8
const std::string kAsciiVtk =
    start("3.0", "ASCII") + kFourPoints +
    "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS 2 9\n3 0 1 2\n4 0 1 2 3\n"
    "CELL_DATA 2\nSCALARS anything at all\n";

void expectVtk(const std::string& bytes) {
  const auto file = readText(bytes);
  EXPECT_EQ(file.report.format, SurfaceFormat::Vtk);
  EXPECT_EQ(file.soup.points,
            (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  ASSERT_EQ(file.soup.polygonCount(), 2U);
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners(file.soup, 1), (Corners{0, 1, 2, 3}));
}

TEST(ReadVtkTest, ReadsAscii) {
  expectVtk(kAsciiVtk);
  expectVtk(replaced(kAsciiVtk, "\n", "\r\n"));
  expectVtk(replaced(kAsciiVtk, "float", "double"));
  expectVtk(replaced(kAsciiVtk, "POLYGONS 2 9\n3 0", "POLYGONS 2 9 3\n0"));
  expectVtk(replaced(kAsciiVtk, "POINTS",
                     "FIELD FieldData 2\nTIME 1 1 double\n0.5\nids 2 2 int\n1 2 3 4\nPOINTS"));
  expectVtk(replaced(kAsciiVtk, "VERTICES", "METADATA\nINFORMATION 0\nNAME x\n\nVERTICES"));
  EXPECT_EQ(readText(kAsciiVtk).report.notes.size(), 1U);
}

TEST(ReadVtkTest, ReadsOffsetsAndConnectivity) {
  expectVtk(start("5.1", "ASCII") + kFourPoints +
            "VERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n0\n"
            "LINES 0 0\nOFFSETS vtktypeint64\nCONNECTIVITY vtktypeint64\n"
            "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 3 7\nCONNECTIVITY vtktypeint64\n"
            "0 1 2 0 1\n2 3\nMETADATA\nINFORMATION 0\n\nPOINT_DATA 4\n");
}

std::string binary(bool offsetsApart) {
  ByteWriter file(std::endian::big);
  file.text(start(offsetsApart ? "5.1" : "4.2", "BINARY") + "FIELD FieldData 1\nTIME 1 1 double\n");
  file.numbers<double>({0.5}).text("\nPOINTS 4 double\n");
  file.numbers<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}).text("\nMETADATA\nX\n\n");
  if (offsetsApart) {
    file.text("POLYGONS 3 7\nOFFSETS vtktypeint64\n").numbers<std::int64_t>({0, 3, 7});
    file.text("\nCONNECTIVITY vtktypeint64\n").numbers<std::int64_t>({0, 1, 2, 0, 1, 2, 3});
  } else {
    file.text("LINES 1 3\n").numbers<std::int32_t>({2, 0, 1});
    file.text("\nPOLYGONS 2 9\n").numbers<std::int32_t>({3, 0, 1, 2, 4, 0, 1, 2, 3});
  }
  return file.text("\nCELL_DATA 2\n").bytes();
}

TEST(ReadVtkTest, ReadsBinary) {
  expectVtk(binary(false));
  expectVtk(binary(true));
  EXPECT_TRUE(readText(binary(true)).report.binary);
}

TEST(ReadVtkTest, TurnsEverySecondTriangleOfAStrip) {
  const auto soup =
      readText(start("3.0", "ASCII") + kFourPoints + "TRIANGLE_STRIPS 2 9\n4 0 1 2 3 3 3 2 1\n")
          .soup;
  ASSERT_EQ(soup.polygonCount(), 3U);
  EXPECT_EQ(corners(soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners(soup, 1), (Corners{2, 1, 3}));
  EXPECT_EQ(corners(soup, 2), (Corners{3, 2, 1}));
  const auto same =
      readText(
          start("5.1", "ASCII") + kFourPoints +
          "TRIANGLE_STRIPS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY int\n0 1 2 3 3 2 1\n")
          .soup;
  EXPECT_EQ(same.corners, soup.corners);
}

TEST(ReadVtkTest, RefusesBadHeaders) {
  expectFailure(replaced(kAsciiVtk, "3.0", "5.2"), "line 1", "5.1");
  expectFailure(replaced(kAsciiVtk, "3.0", "x"), "line 1", "\"x\"");
  expectFailure(replaced(kAsciiVtk, "ASCII", "TEXT"), "line 3", "ASCII");
  expectFailure(replaced(kAsciiVtk, "POLYDATA", "UNSTRUCTURED_GRID"), "line 4",
                "UNSTRUCTURED_GRID");
  expectFailure(replaced(kAsciiVtk, "LINES", "LINE"), "line 11", "\"LINE\"");
  expectFailure(replaced(kAsciiVtk, "LINES", "VERTICES"), "line 11", "a second");
  expectFailure(replaced(kAsciiVtk, "float", "real"), "line 5", "real");
  expectFailure("# vtk DataFile Version 3.0\n", "line 1", "too early");
}

TEST(ReadVtkTest, RefusesBadCounts) {
  expectFailure(replaced(kAsciiVtk, "POINTS 4", "POINTS -4"), "line 5", "-4");
  expectFailure(replaced(kAsciiVtk, "POINTS 4", "POINTS 1000000000000"), "line 5", "promises");
  expectFailure(replaced(kAsciiVtk, "POINTS 4", "POINTS 5"), "line 9", "VERTICES");
  expectFailure(replaced(kAsciiVtk, "POINTS 4", "POINTS 3"), "line 8", "\"0\"");
  const auto polygons = [](const std::string& counts) {
    return replaced(kAsciiVtk, "POLYGONS 2 9", "POLYGONS " + counts);
  };
  expectFailure(polygons("9223372036854775807 9"), "line 13", "promises");
  expectFailure(polygons("2 9223372036854775807"), "line 13", "promises");
  expectFailure(polygons("-2 9"), "line 13", "-2");
  expectFailure(polygons("2 7"), "line 13",
                "2 cells with only 7 numbers, and they take 8 at least");
  expectFailure(polygons("2 8"), "line 15",
                "a cell of 4 points, but only 3 of the numbers are left");
  expectFailure(polygons("2 10"), "line 15",
                "the cells leave 1 of the 10 numbers that the header promises");
  expectFailure(polygons("3 12"), "line 16", "CELL_DATA");
}

TEST(ReadVtkTest, RefusesBadCells) {
  const auto cell = [](const std::string& text) { return replaced(kAsciiVtk, "3 0 1 2\n", text); };
  expectFailure(cell("-1 0 1 2\n"), "line 14",
                "a cell of -1 points, but only 8 of the numbers are left");
  expectFailure(cell("3 0 1 4\n"), "line 14", "index 4");
  expectFailure(cell("3 0 1 -1\n"), "line 14", "index -1");
  expectFailure(cell("3 0 1 4294967297\n"), "line 14", "out of range");
  expectFailure(cell("3 0 1 x\n"), "line 14", "\"x\"");
  expectFailure(replaced(kAsciiVtk, "3 0 1 2\n4 0 1 2 3", "2 0 1 5 0 1 2 3 0"), "line 14",
                "2 corners");
  const std::string strips = start("3.0", "ASCII") + kFourPoints + "TRIANGLE_STRIPS 1 4\n";
  expectFailure(strips + "2 0 1 2\n", "line 10", "2 points");
}

TEST(ReadVtkTest, RefusesBadOffsets) {
  const auto file = [](const std::string& counts, const std::string& offsets,
                       const std::string& type = "int") {
    return start("5.1", "ASCII") + kFourPoints + "POLYGONS " + counts + "\nOFFSETS " + type + "\n" +
           offsets + "\nCONNECTIVITY int\n0 1 2 0 1 2 3\n";
  };
  expectFailure(file("3 7", "1 3 7"), "line 11", "ascend");
  expectFailure(file("3 7", "0 8 7"), "line 11", "ascend");
  expectFailure(file("3 7", "0 3 8"), "line 12",
                "the last offset is 8, not the number of cell points, 7");
  expectFailure(file("3 7", "0 -1 7"), "line 11", "ascend");
  expectFailure(file("4 7", "0 3 3 7"), "line 12",
                "3 cells with only 7 points, and they take 9 at least");
  expectFailure(file("3 7", "0 2 7"), "line 13", "2 corners");
  expectFailure(file("3 7", "0 3 7", "float"), "line 10", "array of indices");
  expectFailure(file("3 7", "0 3 7", "char"), "line 10", "array of indices");
  expectFailure(file("30000 7", "0 3 7"), "line 10", "promises");
}

TEST(ReadVtkTest, RefusesBadBinaryWithItsByte) {
  const std::string good = binary(false);
  const std::size_t polygons = good.find("POLYGONS 2 9\n") + 13;
  const std::string at = "byte " + std::to_string(polygons);
  std::string bad = good;
  bad[polygons + 7] = 4;
  expectFailure(bad, at, "index 4");
  bad = good;
  bad[polygons] = '\x80';
  expectFailure(bad, at, "a cell of -2147483645 points, but only 8 of the numbers are left");
  expectFailure(good.substr(0, polygons + 20), "byte " + std::to_string(polygons - 1), "promises");
  bad = good;
  const std::size_t points = good.find("POINTS 4 double\n") + 16;
  bad[points + 24] = '\x7f';
  bad[points + 25] = '\xf0';
  expectFailure(bad, "byte " + std::to_string(points + 24), "not finite");
}

}  // namespace
}  // namespace cutwater::test
