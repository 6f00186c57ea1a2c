#include "SurfaceFiles.hpp"

namespace cutwater::test {
namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";  // lines 1 to 5

TEST(ReadObjTest, ReadsEveryKindOfCorner) {
  const auto file = readText("# comment\nmtllib /no/such/file.mtl\n" + kPoints +
                             "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 3/1 4/1\nf 1//1 2//1 5//1\n"
                             "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -5 -4 -1\nf 1 2 3 4 5 # n-gon\n");
  EXPECT_EQ(file.report.format, SurfaceFormat::Obj);
  ASSERT_EQ(file.soup.polygonCount(), 6U);
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners(file.soup, 1), (Corners{0, 2, 3}));
  EXPECT_EQ(corners(file.soup, 2), (Corners{0, 1, 4}));
  EXPECT_EQ(corners(file.soup, 3), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(corners(file.soup, 4), (Corners{0, 1, 4}));
  EXPECT_EQ(corners(file.soup, 5), (Corners{0, 1, 2, 3, 4}));
  EXPECT_EQ(file.soup.patchNames, std::vector<std::string>{"test"});
}

TEST(ReadObjTest, ReadsForwardReferencesColoursAndContinuedLines) {
  const auto file =
      readText("f 1 2 \\\n 3\nv 0 0 \\\r\n0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\\\n\nv 7 7 7");
  ASSERT_EQ(file.soup.polygonCount(), 1U);
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(file.soup.points.size(), 4U);
  EXPECT_EQ(file.report.pointsUnused, 1U);
}

TEST(ReadObjTest, NamesPatchesByGroupThenObjectThenMaterial) {
  const auto file =
      readText(kPoints +
               "f 1 2 3\nusemtl steel\nf 1 2 3\no ship\nf 1 2 3\ng hull port\nf 1 2 3\n"
               "g\nf 1 2 3\ng hull port\nf 1 2 3\no boat\nf 1 2 3\ng unused\n");
  EXPECT_EQ(file.soup.patchNames,
            (std::vector<std::string>{"test", "steel", "ship", "hull port", "boat"}));
  EXPECT_EQ(file.soup.patches, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 3, 4}));
}

TEST(ReadObjTest, SaysWhatItLeavesOut) {
  const auto notes = readText(kPoints + "l 1 2\np 1\no a\nusemtl b\nf 1 2 3\n").report.notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].substr(0, 2), "2 ");
}

TEST(ReadObjTest, RefusesBadIndicesWithTheirLine) {
  for (const auto* index :
       {"6", "0", "-6", "4294967297", "9223372036854775808", "9223372036854775807",
        "-9223372036854775808", "18446744073709551617"}) {
    expectFailure(kPoints + "f 1 2 3\nf 1 2 " + index + "\nf 1 2 3\n", "line 7", "out of range");
  }
  expectFailure("f 1 2 3\nf 1 2 4\nv 0 0 0\nv 0 0 1\nv 0 1 0\n", "line 2", "index 4");
  expectFailure(kPoints + "f 1 2\n", "line 6", "2 corners");
  expectFailure(kPoints + "f\n", "line 6", "0 corners");
  expectFailure(kPoints + "f 1 2 3x\n", "line 6", "3x");
  expectFailure(kPoints + "f 1 2 3/a\n", "line 6", "3/a");
  expectFailure(kPoints + "f 1 2 /3\n", "line 6", "missing");
  expectFailure(kPoints + "f 1 2 1.5\n", "line 6", "1.5");
}

TEST(ReadObjTest, RefusesBadPointsAndStatements) {
  expectFailure("v 0 0\nf 1 1 1\n", "line 1", "missing");
  expectFailure("v 0 0 0\nv 0,5 0 0\n", "line 2", "0,5");
  expectFailure("v 0 0 0\nv 0 0 inf\n", "line 2", "not finite");
  expectFailure("v 0 0 0\nv 0 0 -1e999\n", "line 2", "out of range");
  expectFailure("v 0 0 0\nv 0 0 0 red\n", "line 2", "red");
  expectFailure("v 0 0 0\n\n# c\nvx 0 0 0\n", "line 4", "vx");
  expectFailure(std::string("v 0 0 0\nv 0 0 0\0", 16), "line 2", "NUL");
  expectFailure(kPoints + "l 1 2 3\n", "line 6", "no faces");
}

TEST(ReadObjTest, ReadsPolygonsOfAMillionCorners) {
  std::string text = kPoints + "f";
  for (int i = 0; i < 1000000; ++i) text += i % 1000 == 999 ? " 3 \\\n" : i % 2 == 0 ? " 1" : " 2";
  EXPECT_EQ(readText(text).soup.polygon(0).size(), 1000000U);
}

}  // namespace
}  // namespace cutwater::test
