#include "SurfaceFiles.hpp"

namespace cutwater::test {
namespace {

// Line 1 is the solid; facet i has its vertices on lines 4, 5, 6 + 7 i.
const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
    " endloop\nendfacet\n";
const std::string kFacet2 = replaced(kFacet, "vertex 1 0 0", "vertex 0 0 1");
const std::string kAsciiStl = "solid left wing\n" + kFacet + kFacet2 + "endsolid left wing\n";

TEST(ReadStlTest, ReadsAscii) {
  const auto file = readText(kAsciiStl);
  EXPECT_EQ(file.report.format, SurfaceFormat::Stl);
  EXPECT_FALSE(file.report.binary);
  EXPECT_EQ(file.report.pointsInFile, 6U);
  EXPECT_EQ(file.report.pointsMerged, 2U);
  EXPECT_EQ(file.report.polygonsInFile, 2U);
  EXPECT_TRUE(file.report.notes.empty());
  ASSERT_EQ(file.soup.points.size(), 4U);
  EXPECT_EQ(file.soup.points[3], Vec3<double>(0, 0, 1));
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners(file.soup, 1), (Corners{0, 3, 2}));
  EXPECT_EQ(file.soup.patchNames, std::vector<std::string>{"left wing"});
}

TEST(ReadStlTest, ReadsTheSameInEveryLayout) {
  const auto expected = readText(kAsciiStl).soup;
  const std::string upper = replaced(
      replaced(replaced(kAsciiStl, "facet", "FACET"), "vertex", "VERTEX"), "solid ", "SOLID ");
  const std::string oneLine = "solid left wing\n" +
                              replaced(replaced(kFacet + kFacet2, "\n", " "), "  ", "\t") +
                              "\nendsolid";
  for (const auto& text :
       {replaced(kAsciiStl, "\n", "\r\n"), replaced(kAsciiStl, "\n", "\r"),
        replaced(kAsciiStl, "\n", "\n\n"),
        replaced(kAsciiStl, " ", "\t").replace(0, 15, "solid left wing"), upper, oneLine,
        replaced(kAsciiStl, "vertex 1", "vertex +1.0e+00"), "\n \n" + kAsciiStl,
        "\xef\xbb\xbf" + kAsciiStl, replaced(kAsciiStl, "normal 0", "normal -nan(ind)"),
        replaced(kAsciiStl, "normal 0", "normal -1.#IND"),
        kAsciiStl.substr(0, kAsciiStl.size() - 1)}) {
    const auto soup = readText(text).soup;
    EXPECT_EQ(soup.points, expected.points) << text;
    EXPECT_EQ(soup.corners, expected.corners) << text;
    EXPECT_EQ(soup.patchNames, expected.patchNames) << text;
  }
}

TEST(ReadStlTest, EndsolidMayBeMissing) {
  const auto file = readText("solid a\n" + kFacet);
  EXPECT_EQ(file.soup.polygonCount(), 1U);
  EXPECT_EQ(file.report.notes.size(), 1U);
}

TEST(ReadStlTest, KeepsSolidsAsPatches) {
  const std::string text = "solid hull\n" + kFacet + "endsolid hull\nsolid\n" + kFacet +
                           "endsolid\nsolid rudder\nendsolid\nsolid hull\n" + kFacet2 + "endsolid";
  const auto soup = readText(text, {}, "models/ship.v2.stl.gz").soup;
  EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"hull", "ship.v2"}));
  EXPECT_EQ(soup.patches, (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(ReadStlTest, RefusesBadAsciiWithItsLine) {
  const auto bad = [](const std::string& from, const std::string& to) {
    return "solid a\n" + kFacet + replaced(kFacet2, from, to) + "endsolid a\n";
  };
  expectFailure(bad("0 0 1\n  vertex 0 1", "0,5 0 1\n vertex 0 1"), "line 12", "\"0,5\"");
  expectFailure(bad("  vertex 0 0 1\n", ""), "line 13", "a facet has 2 vertices");
  expectFailure(bad("  vertex 0 0 1\n", "vertex 0 0 1\nvertex 0 0 2\n"), "line 15", "4 vertices");
  expectFailure(bad("vertex 0 0 1", "vertex 0 1"), "line 12", "missing");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 abc"), "line 12", "\"abc\"");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 0x1p3"), "line 12", "0x1p3");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 1e400"), "line 12", "out of range");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 nan"), "line 12", "not finite");
  expectFailure(bad("vertex 0 0 1", "vertex 0 -inf 1"), "line 12", "not finite");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 1 1"), "line 12", "expected \"vertex\"");
  expectFailure(bad("normal 0 0 1", "normal 0 0"), "line 9", "missing");
  expectFailure(bad("outer loop", "outer lop"), "line 10", "\"lop\"");
  expectFailure(bad("endfacet\n", ""), "line 15", "endfacet");
  expectFailure(bad("vertex 0 0 1", "vertex 0 0 1\n" + std::string(70000, ' ')), "line 13",
                "64 kB");
  expectFailure(bad("vertex 0 0 1", std::string("vertex 0 0 1\0", 13)), "line 12", "NUL");
  expectFailure("solid a\n" + kFacet + "endsolid\nhello\n", "line 10", "\"hello\"");
  expectFailure("solid a\n" + kFacet + "endsolid\n" + kFacet, "line 10", "\"facet\"");
  expectFailure("solid a\n" + kFacet + "facet normal 0 0 1\nouter loop\n", "line 10", "too early");
  expectFailure("solid a\nendsolid a\n", "line 2", "no faces");
}

TEST(ReadStlTest, LinesMayBeSixtyFourKilobytesLong) {
  EXPECT_NO_THROW(readText("solid " + std::string(64 * 1024 - 6, 'a') + "\n" + kFacet));
  expectFailure("solid " + std::string(64 * 1024 - 5, 'a') + "\n" + kFacet, "line 1", "64 kB");
}

TEST(ReadStlTest, ReadsBinary) {
  const auto file = readText(binaryStl(3), {}, "dir/part.stl");
  EXPECT_TRUE(file.report.binary);
  EXPECT_EQ(file.report.pointsInFile, 9U);
  EXPECT_EQ(file.soup.points.size(), 5U);
  EXPECT_EQ(corners(file.soup, 2), (Corners{0, 1, 4}));
  EXPECT_EQ(file.soup.points[4], Vec3<double>(0, 1, 2));
  EXPECT_EQ(file.soup.patchNames, std::vector<std::string>{"part"});
}

TEST(ReadStlTest, TheWordSolidInTheHeaderProvesNothing) {
  for (const auto* header : {"solid", "solid facet normal", "SOLID \nfacet normal 0 0 1\n"}) {
    EXPECT_EQ(readText(binaryStl(2, 2, header)).soup.polygonCount(), 2U) << header;
  }
}

TEST(ReadStlTest, RefusesBadBinaryWithItsByte) {
  for (const auto* header : {"exported", "solid part"}) {
    const std::string two = binaryStl(2, 2, header);
    expectFailure(binaryStl(2, 3, header), "byte 80", "promises 3 triangles");
    expectFailure(binaryStl(2, 1, header), "byte 80", "promises 1 triangles, but holds 2");
    expectFailure(binaryStl(2, 0, header), "byte 80", "0 triangles");
    expectFailure(binaryStl(2, 0xffffffffU, header), "byte 80", "promises 4294967295");
    expectFailure(two.substr(0, two.size() - 1), "byte 80", "cut off");
    expectFailure(two.substr(0, two.size() - 60), "byte 80", "promises 2");
    expectFailure(two.substr(0, 84), "byte 80", "promises 2");
    EXPECT_EQ(readText(two + "tail").report.notes.size(), 1U);
    expectFailure(two + std::string(100, 'x'), "byte 80", "holds 4");
  }
  expectFailure(binaryStl(2).substr(0, 50), "byte 0", "too short: 50 of the 84 bytes");
}

TEST(ReadStlTest, RefusesNonFiniteBinaryCoordinates) {
  for (const std::uint32_t bits : {0x7f800000U, 0xff800000U, 0x7fc00000U}) {
    std::string bytes = binaryStl(3);
    std::memcpy(bytes.data() + 84 + 50 + 16, &bits, sizeof(bits));
    expectFailure(bytes, "byte 134", "not finite");
    bytes = binaryStl(3);
    std::memcpy(bytes.data() + 84 + 50, &bits, sizeof(bits));
    EXPECT_EQ(readText(bytes).soup.polygonCount(), 3U) << "normals do not count";
  }
}

}  // namespace
}  // namespace cutwater::test
