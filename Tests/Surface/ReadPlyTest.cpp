#include "SurfaceFiles.hpp"

namespace cutwater::test {
namespace {

// The data begin on line 10.
std::string header(const std::string& encoding, const std::string& points = "3",
                   const std::string& faces = "1", const std::string& list = "uchar int") {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " + points +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}
const std::string kRows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

void expectTriangle(const std::string& bytes) {
  const auto file = readText(bytes);
  EXPECT_EQ(file.report.format, SurfaceFormat::Ply);
  EXPECT_EQ(file.soup.points, (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  ASSERT_EQ(file.soup.polygonCount(), 1U);
  EXPECT_EQ(corners(file.soup, 0), (Corners{0, 1, 2}));
}

TEST(ReadPlyTest, ReadsAsciiInEveryLayout) {
  const std::string text = header("ascii") + kRows;
  for (const auto& variant :
       {text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"),
        replaced(text, "float", "float32"), replaced(text, "float", "double"),
        replaced(text, "float", "float64"), replaced(text, "uchar int", "int uint"),
        replaced(text, "uchar int", "uint8 ushort"),
        replaced(text, "vertex_indices", "vertex_index"),
        replaced(text, "ply\nformat", "ply\ncomment before\nobj_info x\nformat"),
        replaced(text, "3 0 1 2\n", "\n3 0 1 2"), text + "\n\n"}) {
    expectTriangle(variant);
  }
}

TEST(ReadPlyTest, SkipsWhatIsNoGeometry) {
  expectTriangle(
      "ply\nformat ascii 1.0\nelement empty 1000000000000\nelement face 1\n"
      "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
      "property uchar red\nelement edge 2\nproperty int a\nproperty list int float b\n"
      "element vertex 3\nproperty uchar red\nproperty double z\nproperty float x\nproperty int y\n"
      "property list uchar int extra\nend_header\n"
      "2 0.5 0.5 3 0 1 2 255\n1 2 0.5 0.5\n1 0\n9 0 0 0 0\n9 0 1 0 1 7\n9 0 0 1 2 7 7\n");
}

template <typename Index>
std::string binaryTriangle(const std::string& encoding, std::endian order,
                           const std::string& list) {
  ByteWriter file(order);
  file.text(header(encoding, "3", "1", list));
  file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).numbers<Index>({3, 0, 1, 2});
  return file.bytes();
}

TEST(ReadPlyTest, ReadsBothByteOrders) {
  for (const auto order : {std::endian::little, std::endian::big}) {
    const std::string encoding =
        order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    expectTriangle(binaryTriangle<std::uint8_t>(encoding, order, "uchar uchar"));
    expectTriangle(binaryTriangle<std::int8_t>(encoding, order, "char int8"));
    expectTriangle(binaryTriangle<std::int32_t>(encoding, order, "int int32"));
    expectTriangle(binaryTriangle<std::uint32_t>(encoding, order, "uint uint32"));
    expectTriangle(binaryTriangle<std::uint16_t>(encoding, order, "ushort uint16"));
    expectTriangle(binaryTriangle<std::int16_t>(encoding, order, "short int16"));
    expectTriangle(binaryTriangle<std::int16_t>(encoding, order, "short int16") + "\n");
  }
}

TEST(ReadPlyTest, SkipsBinaryExtras) {
  ByteWriter file(std::endian::big);
  file.text(
      "ply\nformat binary_big_endian 1.0\nelement face 1\n"
      "property list uchar float texcoord\nproperty list uint ushort vertex_indices\n"
      "property double quality\nelement other 2\nproperty list uchar double a\n"
      "element vertex 3\nproperty short y\nproperty double x\nproperty uchar red\n"
      "property double z\nend_header\n");
  file.numbers<std::uint8_t>({1}).numbers<float>({0.5F}).numbers<std::uint32_t>({3});
  file.numbers<std::uint16_t>({0, 1, 2}).numbers<double>({1.5});
  file.numbers<std::uint8_t>({2}).numbers<double>({1, 2}).numbers<std::uint8_t>({0});
  const auto point = [&](std::int16_t y, double x) {
    file.numbers<std::int16_t>({y}).numbers<double>({x}).numbers<std::uint8_t>({7});
    file.numbers<double>({0});
  };
  point(0, 0);
  point(0, 1);
  point(1, 0);
  expectTriangle(file.bytes());
}

TEST(ReadPlyTest, BinaryDataMayBeginWithALineFeed) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    ByteWriter file;
    file.text(replaced(replaced(header("binary_little_endian"), "float x", "char x"), "\n", end));
    for (const auto& [x, y] : {std::pair{'\n', 0.0F}, {'\r', 0.0F}, {'\n', 1.0F}}) {
      file.numbers<char>({x}).numbers<float>({y, 0});
    }
    file.numbers<std::uint8_t>({3}).numbers<std::int32_t>({0, 1, 2});
    const auto soup = readText(file.bytes()).soup;
    EXPECT_EQ(soup.points[0], Vec3<double>(10, 0, 0));
    EXPECT_EQ(soup.points[1], Vec3<double>(13, 0, 0));
  }
}

TEST(ReadPlyTest, RefusesBadCounts) {
  expectFailure(header("ascii", "-1") + kRows, "line 3", "-1");
  expectFailure(header("ascii", "abc") + kRows, "line 3", "\"abc\"");
  expectFailure(header("ascii", "") + kRows, "line 3", "missing");
  expectFailure(header("ascii", "9223372036854775807") + kRows, "line 9", "promises");
  expectFailure(header("ascii", "9223372036854775808") + kRows, "line 3", "out of range");
  expectFailure(header("ascii", "3", "1000") + kRows, "line 12", "promises 1000");
  expectFailure(header("ascii", "3", "2") + kRows, "line 12", "promises");
  expectFailure(header("ascii", "2") + kRows, "line 12", "corners");
  expectFailure(header("ascii") + kRows + "3 0 1 2\n", "line 14", "more lines");
  expectFailure(header("ascii", "3", "0") + replaced(kRows, "3 0 1 2\n", ""), "line 12",
                "no faces");
}

TEST(ReadPlyTest, RefusesBadLists) {
  const auto row = [](const std::string& face) {
    return header("ascii") + replaced(kRows, "3 0 1 2", face);
  };
  expectFailure(row("-1 0 1 2"), "line 13", "-1");
  expectFailure(row("2147483648 0 1 2"), "line 13", "promises 2147483648");
  expectFailure(row("2 0 1"), "line 13", "2 corners");
  expectFailure(row("4 0 1 2"), "line 13", "missing");
  expectFailure(row("3 0 1 2 2"), "line 13", "end of the line");
  expectFailure(row("3 0 1 3"), "line 13", "index 3 is out of range");
  expectFailure(row("3 0 1 -1"), "line 13", "index -1");
  expectFailure(row("3 0 1 4294967297"), "line 13", "out of range");
  expectFailure(row("3 0 1 9223372036854775808"), "line 13", "out of range");
  expectFailure(row("3 0 1 nan"), "line 13", "nan");
}

TEST(ReadPlyTest, RefusesBadBinaryData) {
  const std::string good =
      binaryTriangle<std::int32_t>("binary_little_endian", std::endian::little, "int int32");
  const std::size_t data = good.size() - 52;
  const std::string points = "byte " + std::to_string(data);
  const std::string face = "byte " + std::to_string(data + 36);
  const auto with = [&](std::size_t at, std::int32_t value) {
    std::string bytes = good;
    std::memcpy(bytes.data() + data + at, &value, sizeof(value));
    return bytes;
  };
  expectFailure(with(36, -1), face, "-1");
  expectFailure(with(36, INT32_MIN), face, "-2147483648");
  expectFailure(with(36, 4), face, "promises 4");
  expectFailure(with(36, 2), face, "2 corners");
  expectFailure(with(40, 3), face, "index 3");
  expectFailure(with(40, -1), face, "index -1");
  expectFailure(with(16, 0x7f800000), "byte " + std::to_string(data + 12), "not finite");
  expectFailure(good.substr(0, good.size() - 1), face, "too early");
  expectFailure(good.substr(0, data + 20), points, "promises 3");
  expectFailure(good + "xyz", "byte " + std::to_string(good.size()), "behind the last");
  expectFailure(replaced(good, "vertex 3", "vertex 9223372036854775807"),
                "byte " + std::to_string(data + 18), "promises 9223372036854775807");
}

TEST(ReadPlyTest, RefusesBadHeaders) {
  const std::string good = header("ascii") + kRows;
  expectFailure(replaced(good, "float x", "float a"), "line 9", "x, y and z");
  expectFailure(replaced(good, "property float x", "property list uchar float x"), "line 9",
                "x, y");
  expectFailure(replaced(good, "vertex_indices", "indices"), "line 12", "vertex_indices");
  expectFailure(header("ascii", "3", "1", "uchar float") + kRows, "line 12", "vertex_indices");
  expectFailure(header("ascii", "3", "1", "float int") + kRows, "line 8", "integer count");
  expectFailure(replaced(good, "float x", "flaot x"), "line 4", "flaot");
  expectFailure(replaced(good, "float x", "float"), "line 4", "name is missing");
  expectFailure(replaced(good, "ascii", "asci"), "line 2", "asci");
  expectFailure(replaced(good, "1.0", "2.0"), "line 2", "2.0");
  expectFailure(replaced(good, "format ascii 1.0\n", ""), "line 8", "no format");
  expectFailure(replaced(good, "end_header", "end"), "line 9", "\"end\"");
  expectFailure("ply\nformat ascii 1.0\n", "line 2", "end_header");
  expectFailure("ply\nproperty int a\n", "line 2", "before any element");
  expectFailure(replaced(good, "element face", "element vertex"), "line 7", "a second element");
  std::string wide = "ply\nformat ascii 1.0\nelement a 1\n";
  for (int i = 0; i < 5000; ++i) wide += "property int a\n";
  expectFailure(wide, "line 4100", "too many");
  std::string many = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 300; ++i) many += "element a" + std::to_string(i) + " 1\n";
  expectFailure(many, "line 259", "too many");
}

}  // namespace
}  // namespace cutwater::test
