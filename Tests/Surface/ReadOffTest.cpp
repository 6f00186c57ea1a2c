#include "SurfaceFiles.hpp"

namespace cutwater::test {
namespace {

const std::string kOff = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 1 2 3\n";

void expectOff(const std::string& text) {
  const auto file = readText(text);
  EXPECT_EQ(file.report.format, SurfaceFormat::Off);
  EXPECT_EQ(file.soup.points,
            (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}))
      << text;
  ASSERT_EQ(file.soup.polygonCount(), 2U) << text;
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2})) << text;
  EXPECT_EQ(corners(file.soup, 1), (Corners{0, 1, 2, 3})) << text;
}

TEST(ReadOffTest, ReadsEveryLayout) {
  for (const auto& text :
       {kOff, replaced(kOff, "\n", "\r\n"), replaced(kOff, "\n", "\r"), replaced(kOff, " ", "\t"),
        replaced(kOff, "\n", "\n\n"), replaced(kOff, "\n", " # comment\n#another\n"),
        replaced(kOff, "\n", "#comment\n"), replaced(kOff, "OFF\n4", "OFF 4"),
        replaced(kOff, "4 2 0", "4 2"), replaced(kOff, "OFF", "off"), "# first\n\n" + kOff,
        kOff.substr(0, kOff.size() - 1)}) {
    expectOff(text);
  }
}

TEST(ReadOffTest, ReadsColoursAndNormals) {
  expectOff(replaced(replaced(replaced(kOff, "OFF", "COFF"), "0 0 0\n", "0 0 0 255 0 0 255\n"),
                     "3 0 1 2\n", "3 0 1 2 0.5 0.5 0.5\n"));
  expectOff(replaced(replaced(kOff, "OFF", "NOFF"), "1 0 0\n", "1 0 0 0 0 1\n"));
  expectOff(replaced(kOff, "OFF", "STCNOFF"));
  expectOff(replaced(kOff, "3 0 1 2\n", "3 0 1 2 4 255 0 0\n"));
}

TEST(ReadOffTest, RefusesCountsThatLie) {
  expectFailure(replaced(kOff, "4 2 0", "5 2 0"), "line 8", "a face");
  expectFailure(replaced(kOff, "4 2 0", "3 2 0"), "line 6", "0 corners");
  expectFailure(replaced(kOff, "4 2 0", "4 3 0"), "line 8", "a face");
  expectFailure(replaced(kOff, "4 2 0", "4 1 0"), "line 8", "more lines");
  expectFailure(replaced(kOff, "4 2 0", "-1 2 0"), "line 2", "-1");
  expectFailure(replaced(kOff, "4 2 0", "4 -1 0"), "line 2", "-1");
  expectFailure(replaced(kOff, "4 2 0", "1000000000000 2 0"), "line 2", "promises 1000000000000");
  expectFailure(replaced(kOff, "4 2 0", "4 9223372036854775807 0"), "line 2", "promises");
  expectFailure(replaced(kOff, "4 2 0", "4 18446744073709551617 0"), "line 2", "out of range");
  expectFailure(replaced(kOff, "4 2 0", "4.0 2 0"), "line 2", "4.0");
  expectFailure(replaced(kOff, "4 2 0", "4"), "line 2", "missing");
  expectFailure("OFF\n0 0 0\n", "line 2", "no faces");
  expectFailure("OFF\n", "line 1", "number of points");
}

TEST(ReadOffTest, RefusesBadRows) {
  expectFailure(replaced(kOff, "3 0 1 2", "-1 0 1 2"), "line 7", "-1");
  expectFailure(replaced(kOff, "3 0 1 2", "2147483648 0 1 2"), "line 7", "promises");
  expectFailure(replaced(kOff, "3 0 1 2", "3 0 1"), "line 7", "missing");
  expectFailure(replaced(kOff, "3 0 1 2", "3 0 1 4"), "line 7", "index 4 is out of range");
  expectFailure(replaced(kOff, "3 0 1 2", "3 0 1 4294967296"), "line 7", "out of range");
  expectFailure(replaced(kOff, "3 0 1 2", "2 0 1"), "line 7", "2 corners");
  expectFailure(replaced(kOff, "1 0 0\n", "1 0\n"), "line 4", "missing");
  expectFailure(replaced(kOff, "1 0 0\n", "1 0 1e999\n"), "line 4", "out of range");
  expectFailure(replaced(kOff, "1 0 0\n", "1 0 nan\n"), "line 4", "not finite");
  expectFailure(replaced(kOff, "1 0 0\n", "1 0 0 red\n"), "line 4", "red");
  expectFailure(replaced(kOff, "OFF", "OFF BINARY"), "line 1", "binary");
}

}  // namespace
}  // namespace cutwater::test
