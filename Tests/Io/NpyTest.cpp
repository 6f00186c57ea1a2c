#include "PointFile.hpp"

namespace cutwater::test {
namespace {

class NpyTest : public PointFile {
 protected:
  static std::string start(const std::string& header, int version = 1) {
    std::string bytes = "\x93NUMPY";
    bytes += static_cast<char>(version);
    bytes += '\0';
    bytes += version == 1 ? bytesOf({static_cast<std::uint16_t>(header.size())})
                          : bytesOf({static_cast<std::uint32_t>(header.size())});
    return bytes + header;
  }
  static constexpr const char* kTwoDoubles =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }       \n";
  const std::string twelve = bytesOf<double>({1, -2.5, 3e-3, 0, 0.1, 1e6});
  const std::vector<Vec3<double>> expected{{1, -2.5, 3e-3}, {0, 0.1, 1e6}};
};

TEST_F(NpyTest, ReadsDoublesAndFloatsOfAllVersions) {
  for (const int version : {1, 2, 3}) {
    const auto data = read(start(kTwoDoubles, version) + twelve);
    EXPECT_EQ(data.points, expected);
    EXPECT_EQ(data.mesh, DataMesh::Points);
    EXPECT_FALSE(data.singlePrecision);
  }
  const auto single = read(start("{\"shape\":(1,3),\"fortran_order\":False,\"descr\":\"<f4\"}") +
                           bytesOf<float>({0.1F, 2, -3}));
  EXPECT_EQ(single.points, (std::vector<Vec3<double>>{{double{0.1F}, 2, -3}}));
  EXPECT_TRUE(single.singlePrecision);
  EXPECT_TRUE(
      read(start("{'descr': '<f8', 'fortran_order': False, 'shape': (0, 3)}")).points.empty());
}

TEST_F(NpyTest, RefusesOtherArrays) {
  const auto of = [&](const std::string& type, const std::string& order, const std::string& shape) {
    return refusal(start("{'descr': " + type + ", 'fortran_order': " + order +
                         ", 'shape': " + shape + ", }\n") +
                   twelve);
  };
  EXPECT_EQ(of("'<f8'", "False", "(2, 3)"), "nothing");
  EXPECT_NE(of("'>f8'", "False", "(2, 3)").find("little-endian"), std::string::npos);
  EXPECT_NE(of("'<i8'", "False", "(2, 3)").find("\"<i8\""), std::string::npos);
  EXPECT_NE(of("'|O'", "False", "(2, 3)").find("\"|O\""), std::string::npos);
  EXPECT_NE(of("[('x', '<f8')]", "False", "(2, 3)").find("structures"), std::string::npos);
  EXPECT_NE(of("'<f8'", "True", "(2, 3)").find("Fortran order"), std::string::npos);
  EXPECT_NE(of("'<f8'", "False", "(3, 2)").find("(3, 2)"), std::string::npos);
  EXPECT_NE(of("'<f8'", "False", "(6,)").find("(6,)"), std::string::npos);
  EXPECT_NE(of("'<f8'", "False", "()").find("found ()"), std::string::npos);
  EXPECT_NE(of("'<f8'", "False", "(1, 2, 3)").find("(1, 2, 3)"), std::string::npos);
}

TEST_F(NpyTest, RefusesCountsThatTheFileHasNoRoomFor) {
  for (const char* count : {"1", "3", "4611686018427387904", "18446744073709551615"}) {
    const auto message = refusal(start("{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                                       std::string(count) + ", 3)}") +
                                 twelve);
    EXPECT_NE(message.find("promises " + std::string(count) + " points, and 48 bytes follow"),
              std::string::npos)
        << message;
  }
  EXPECT_NE(refusal(start(kTwoDoubles) + twelve.substr(1)).find("and 47 bytes"), std::string::npos);
}

TEST_F(NpyTest, RefusesDamagedHeaders) {
  EXPECT_EQ(refusal("\x93NUMPY"), "byte 6: the file ends too early");
  EXPECT_EQ(refusal(std::string("\x93NUMPY\4\0\0\0", 10)),
            "byte 6: version 4.0 is none of 1.0, 2.0 and 3.0");
  EXPECT_EQ(refusal(std::string("\x93NUMPY\1\0\377\0", 10)),
            "byte 6: the file ends within its header");
  for (const char* header :
       {"", "{", "{}", "{'descr': '<f8'}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)",
        "{'descr': '<f8', 'fortran_order': Maybe, 'shape': (2, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, -3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 36893488147419103232)}",
        "{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), 'more': 1}",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)} x",
        "{'descr: <f8, fortran_order: False"}) {
    EXPECT_TRUE(refusal(start(header) + twelve).starts_with("byte 10: ")) << header;
  }
}

TEST_F(NpyTest, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_EQ(refusal(start(kTwoDoubles) +
                    bytesOf<double>({1, 2, 3, 4, std::numeric_limits<double>::infinity(), 6})),
            "byte " + std::to_string(10 + std::strlen(kTwoDoubles) + 24) +
                ": a coordinate is not finite");
}

TEST_F(NpyTest, WritesAStructurePerPoint) {
  const PointData data{.points = {{1, 2, 3}, {4, 5, 6}},
                       .pointArrays = {{"it's", std::vector<double>{7, 8}},
                                       {"n", std::vector<float>{1, 0, 0, 0, 1, 0}, 3},
                                       {"patch", std::vector<std::int32_t>{-1, 2}}}};
  writePointData(folder / "a.npy", data);
  const auto bytes = contentOf(folder / "a.npy");
  const std::string body = bytesOf<double>({1, 2, 3, 7}) + bytesOf<float>({1, 0, 0}) +
                           bytesOf<std::int32_t>({-1}) + bytesOf<double>({4, 5, 6, 8}) +
                           bytesOf<float>({0, 1, 0}) + bytesOf<std::int32_t>({2});
  ASSERT_EQ(bytes.size() % 64, body.size() % 64);
  const std::string head =
      "{'descr': [('points', '<f8', (3,)), ('it\\'s', '<f8'), ('n', '<f4', (3,)), ('patch', "
      "'<i4')], 'fortran_order': False, 'shape': (2,), }";
  EXPECT_EQ(bytes.substr(10, head.size()), head);
  EXPECT_EQ(bytes.substr(bytes.size() - body.size()), body);
  EXPECT_EQ(bytes[bytes.size() - body.size() - 1], '\n');
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\1\0", 8));
  EXPECT_EQ(bytes.substr(8, 2),
            bytesOf({static_cast<std::uint16_t>(bytes.size() - body.size() - 10)}));
}

}  // namespace
}  // namespace cutwater::test
