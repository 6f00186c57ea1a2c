#include <cmath>

#include "PointFile.hpp"

namespace cutwater::test {
namespace {

using PointTableTest = PointFile;

const std::vector<Vec3<double>> kTwoPoints{{1, -2.5, 3e-3}, {0, 0, 1e6}};

TEST_F(PointTableTest, ReadsPointsWithAndWithoutNames) {
  EXPECT_EQ(read("1,-2.5,3e-3\n0,0,1e6\n").points, kTwoPoints);
  EXPECT_EQ(read("x,y,z\n1,-2.5,3e-3\n0,0,1e6").points, kTwoPoints);
  EXPECT_EQ(
      read("\xef\xbb\xbf# of a run\r\n\r\nX, Y, Z\r\n 1 ,\t-2.5, .003\r\n+0,0,1e6\r\n").points,
      kTwoPoints);
  EXPECT_EQ(read("\"Points:0\",\"Points:1\",\"Points:2\"\n1,-2.5,3e-3\n0,0,1e6\n").points,
            kTwoPoints);
}

TEST_F(PointTableTest, KeepsOtherColumnsInTheirOrder) {
  const auto data = read("p,z,\"U:0\",x,y\n5,3e-3,nan,1,-2.5\n-inf,1e6,7,0,0\n");
  EXPECT_EQ(data.points, kTwoPoints);
  ASSERT_EQ(data.pointArrays.size(), 2U);
  EXPECT_EQ(data.pointArrays[0].name, "p");
  EXPECT_EQ(numbersOf(data.pointArrays[0]),
            (std::vector<double>{5, -std::numeric_limits<double>::infinity()}));
  EXPECT_EQ(data.pointArrays[1].name, "U:0");
  EXPECT_TRUE(std::isnan(numbersOf(data.pointArrays[1])[0]));
  EXPECT_EQ(numbersOf(data.pointArrays[1])[1], 7);
  EXPECT_EQ(read("1,2,3,4\n").pointArrays[0].name, "column 4");
}

TEST_F(PointTableTest, RefusesWhatIsNoTableOfPoints) {
  const auto missing = [](const std::string& name) {
    return "line 1: need columns named x, y and z, with commas between them; there is no " + name;
  };
  EXPECT_EQ(refusal("x,y\n1,2\n"), missing("z"));
  EXPECT_EQ(refusal("a,b,c\n1,2,3\n"), missing("x"));
  EXPECT_EQ(refusal("x y z\n1 2 3\n"), missing("x"));
  EXPECT_EQ(refusal("x,y,z,p,p\n1,2,3,4,5\n"), "line 1: two columns named \"p\"");
  EXPECT_EQ(refusal("x,y,z,x\n1,2,3,4\n"), "nothing");  // the first is the coordinate
  EXPECT_EQ(refusal("x,y,z,\n1,2,3,4\n"), "line 1: column 4 has no name");
  EXPECT_EQ(refusal("1,2\n"), "line 1: need at least 3 fields, found 2");
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n1,2\n"), "line 3: need 3 fields, found 2");
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n\n1,,3\n"), "line 4: field 2 is empty");
  EXPECT_EQ(refusal("x,y,z,p\n1,2,3,wall\n"), "line 2: expected a number, found \"wall\"");
  EXPECT_EQ(refusal("x,y,z\n1,2,nan\n"), "line 2: need finite numbers, found \"nan\"");
  EXPECT_EQ(refusal("1,2,1e400\n"), "line 1: \"1e400\" is out of range");
  EXPECT_EQ(refusal("x,y,z\n# nothing\n"), "line 2: the file ends without a point");
  EXPECT_EQ(refusal(std::string("1,2,3\n1,2\0,3\n", 13)), "line 2: a NUL byte in text");
  std::string wide = "1";
  for (int i = 0; i < 1024; ++i) wide += ",1";
  EXPECT_EQ(refusal(wide + "\n"), "line 1: more than 1024 columns");
}

TEST_F(PointTableTest, WritesWhatReadsBackToTheBit) {
  PointData data{.points = {{0.1, -1.0 / 3, 5e-324}, {1e300, -0.0, 3}}};
  data.pointArrays = {{"p", std::vector<double>{0.1, 1.0 / 3}},
                      {"U", std::vector<float>{0.1F, 2, 3, 4, 5, 6}, 3},
                      {"tags", std::vector<std::uint8_t>{1, 255, 3, 4}, 2},
                      {"id", std::vector<std::uint64_t>{18446744073709551615U, 0}}};
  writePointData(folder / "a.CSV", data);
  EXPECT_EQ(contentOf(folder / "a.CSV"),
            "x,y,z,p,U_x,U_y,U_z,tags_0,tags_1,id\n"
            "0.1,-0.3333333333333333,5e-324,0.1,0.1,2,3,1,255,18446744073709551615\n"
            "1e+300,-0,3,0.3333333333333333,4,5,6,3,4,0\n");
  const auto back = readPointData(folder / "a.CSV");
  EXPECT_EQ(back.points, data.points);
  EXPECT_EQ(back.pointArrays[0], data.pointArrays[0]);
  EXPECT_EQ(back.pointArrays.size(), 7U);
}

TEST_F(PointTableTest, RefusesNamesAndCellsThatATableHasNoPlaceFor) {
  PointData data{.points = {{1, 2, 3}}, .pointArrays = {{"a,b", std::vector<double>{1}}}};
  EXPECT_NE(writeRefusal(data, "a.csv").find("\"a,b\" does not fit a table"), std::string::npos);
  data.pointArrays.clear();
  data.mesh = DataMesh::Unstructured;
  data.cells = {.kinds = {1}, .offsets = {0, 1}, .corners = {0}};
  EXPECT_NE(writeRefusal(data, "a.csv").find("the data have cells"), std::string::npos);
  EXPECT_NE(writeRefusal(data, "a.npy").find("the data have cells"), std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
