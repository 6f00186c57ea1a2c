#include <random>

#include "SampleFiles.hpp"
#include "Support/AllocationCount.hpp"
#include "Support/CpuTime.hpp"

namespace cutwater::test {
namespace {

// Reads, and checks what every read must keep: an Error or a whole valid soup, in bounded memory.
// Number of polygons, 0 after an Error.
std::size_t readAnyhow(const std::string& bytes, double mostPerByte = 16) {
  // What does not grow with the file: messages, first chunks, small tables.
  constexpr std::size_t kConstant = 300000;
  const AllocationCount count;
  std::size_t polygons = 0;
  try {
    const auto file = readText(bytes);
    file.soup.validate();
    polygons = file.soup.polygonCount();
    EXPECT_GT(polygons, 0U);
    EXPECT_EQ(file.report.polygonsInFile, polygons);
    for (const auto patch : file.soup.patches) EXPECT_LT(patch, file.soup.patchNames.size());
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("test: ")) << error.what();
  }
  const double allowed = mostPerByte * static_cast<double>(bytes.size());
  EXPECT_LT(static_cast<double>(count.peakBytes()), allowed + kConstant) << bytes.substr(0, 200);
  return polygons;
}

TEST(ReaderRobustnessTest, TruncatedFilesAreRefusedOrWhole) {
  for (const auto& sample : sampleFiles()) {
    SCOPED_TRACE(sample.name);
    const std::size_t whole = readAnyhow(sample.bytes);
    ASSERT_GT(whole, 0U);
    // Text formats without counts may end behind any face; OBJ and ASCII STL are the only ones.
    const bool counted = sample.name != "text.obj" && sample.name != "ascii.stl";
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const std::size_t polygons = readAnyhow(sample.bytes.substr(0, size));
      EXPECT_LE(polygons, whole) << size;
      if (counted && polygons > 0 && sample.name != "ascii3.vtk") {
        EXPECT_EQ(polygons, whole) << size << " of " << sample.bytes.size();
      }
    }
  }
}

TEST(ReaderRobustnessTest, MutatedFilesNeverCrash) {
  std::mt19937 random(3);
  for (const auto& sample : sampleFiles()) {
    SCOPED_TRACE(sample.name);
    std::uniform_int_distribution<std::size_t> position(0, sample.bytes.size() - 1);
    std::uniform_int_distribution<int> byte(0, 255);
    int read = 0;
    for (int i = 0; i < 2000; ++i) {
      std::string bytes = sample.bytes;
      bytes[position(random)] = static_cast<char>(byte(random));
      if (readAnyhow(bytes) > 0) ++read;
    }
    EXPECT_LT(read, 2000);
  }
}

// Digits, signs, separators and keywords where they do not belong reach further than random bytes.
TEST(ReaderRobustnessTest, SplicedFilesNeverCrash) {
  const std::vector<std::string> pieces = {"-1",
                                           "0",
                                           "4294967295",
                                           "4294967296",
                                           "9223372036854775807",
                                           "1e400",
                                           "nan",
                                           "\n",
                                           "\r",
                                           " ",
                                           "\\\n",
                                           "#",
                                           "3 0 1 2\n",
                                           "f 1 2 3\n",
                                           "POLYGONS 1 4\n",
                                           "property list uchar int x\n",
                                           "element face 3\n",
                                           std::string("\0\0\0\0", 4),
                                           "\xff\xff\xff\xff",
                                           "\x7f",
                                           "endsolid\n"};
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> piece(0, pieces.size() - 1);
  for (const auto& sample : sampleFiles()) {
    SCOPED_TRACE(sample.name);
    std::uniform_int_distribution<std::size_t> position(0, sample.bytes.size() - 1);
    std::uniform_int_distribution<std::size_t> length(0, 8);
    for (int i = 0; i < 2000; ++i) {
      std::string bytes = sample.bytes;
      const std::size_t at = position(random);
      bytes.replace(at, std::min(length(random), bytes.size() - at), pieces[piece(random)]);
      readAnyhow(bytes);
    }
  }
}

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  text.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

std::string plyHeader(const std::string& encoding, const std::string& points,
                      const std::string& type, const std::string& faces) {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " + points + "\nproperty " + type +
         " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " + faces +
         "\nproperty list uchar uchar vertex_indices\nend_header\n";
}

// The densest files: as much soup as possible for each byte.
TEST(ReaderRobustnessTest, MemoryStaysWithinSixteenTimesTheFile) {
  constexpr std::size_t kMany = 400000;  // just behind a growth of the hash table
  const std::string many = std::to_string(kMany);
  const std::string vtk =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 1 int\n0 0 0 ";
  EXPECT_GT(readAnyhow("v 0 0 0\n" + repeated("f 1 1 1\n", kMany)), 0U);
  EXPECT_GT(readAnyhow(repeated("v 0 0 0\n", kMany) + "f 1 1 1\n"), 0U);
  std::string groups = "v 0 0 0\n";
  std::string points;
  for (std::size_t i = 0; i < kMany; ++i) {
    const std::string name = {static_cast<char>('a' + i % 26), static_cast<char>('a' + i / 26 % 26),
                              static_cast<char>('a' + i / 676 % 26),
                              static_cast<char>('A' + i / 17576)};
    groups += "g " + name + "\nf 1 1 1\n";
    points += "v " + std::to_string(i % 100) + " " + std::to_string(i / 100 % 100) + " " +
              std::to_string(i / 10000) + "\n";
  }
  EXPECT_EQ(readAnyhow(groups), kMany);
  EXPECT_GT(readAnyhow(points + "f 1 2 3\n"), 0U);
  EXPECT_GT(readAnyhow("OFF\n1 " + many + "\n0 0 0\n" + repeated("3 0 0 0\n", kMany)), 0U);
  EXPECT_GT(readAnyhow("OFF\n" + many + " 1\n" + repeated("0 0 0\n", kMany) + "3 0 0 0\n"), 0U);
  EXPECT_GT(readAnyhow(vtk + "TRIANGLE_STRIPS 1 " + std::to_string(kMany + 1) + "\n" + many + "\n" +
                       repeated(repeated("0 ", 1000) + "\n", kMany / 1000)),
            0U);
  EXPECT_GT(readAnyhow(vtk + "POLYGONS 1 " + std::to_string(kMany + 1) + "\n" + many + "\n" +
                       repeated(repeated("0 ", 1000) + "\n", kMany / 1000)),
            0U);
  const std::string little = "binary_little_endian";
  EXPECT_GT(readAnyhow(plyHeader(little, "1", "uchar", many) + std::string(3, '\0') +
                       repeated(std::string("\3\0\0\0", 4), kMany)),
            0U);
  EXPECT_GT(readAnyhow(plyHeader(little, "1", "uchar", std::to_string(kMany / 250)) +
                       std::string(3, '\0') +
                       repeated(std::string("\xff") + std::string(255, '\0'), kMany / 250)),
            0U);
  std::string grid;
  for (std::size_t i = 0; i < kMany; ++i) {
    grid += {static_cast<char>(i), static_cast<char>(i >> 8U), static_cast<char>(i >> 16U)};
  }
  EXPECT_GT(readAnyhow(plyHeader(little, many, "uchar", "1") + grid + std::string("\3\0\1\2", 4)),
            0U);
  EXPECT_GT(readAnyhow(binaryStl(100000)), 0U);
}

// Promises that the file cannot keep must not be believed, not even in part.
TEST(ReaderRobustnessTest, CountsThatLieCostNothing) {
  const std::string rows = repeated("0 0 0\n", 1000);
  for (const auto* count :
       {"7000", "4294967295", "4294967296", "1000000000000", "9223372036854775807"}) {
    const std::string text = count;
    readAnyhow("OFF\n" + text + " " + text + "\n" + rows);
    readAnyhow("OFF\n1 " + text + "\n" + rows);
    readAnyhow("OFF\n1 1\n0 0 0\n" + text + " 0 0 0\n" + rows);
    for (const auto* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      readAnyhow(plyHeader(encoding, text, "uchar", text) + rows);
      readAnyhow(plyHeader(encoding, "1", "uchar", text) + rows);
      readAnyhow("ply\nformat " + std::string(encoding) + " 1.0\nelement nothing " + text +
                 "\nelement something " + text + "\nproperty char a\nend_header\n" + rows);
    }
    for (const auto* encoding : {"ASCII", "BINARY"}) {
      const std::string vtk =
          "# vtk DataFile Version 5.1\n\n" + std::string(encoding) + "\nDATASET POLYDATA\n";
      const std::string old = replaced(vtk, "5.1", "3.0");
      for (const auto& head : {vtk, old}) {
        readAnyhow(head + "POINTS " + text + " float\n" + rows);
        readAnyhow(head + "POLYGONS 1 " + text + "\n" + rows);
        readAnyhow(head + "POLYGONS " + text + " " + text + "\n" + rows);
        readAnyhow(head + "TRIANGLE_STRIPS 1 " + text + "\n" + text + " " + rows);
        readAnyhow(head + "FIELD f 1\na " + text + " " + text + " int\n" + rows);
        readAnyhow(head + "FIELD f 1\na 0 " + text + " int\n" + rows);
        readAnyhow(head + "FIELD f " + text + "\n" + rows);
      }
      readAnyhow(vtk + "POLYGONS " + text + " 6\nOFFSETS int\n" + rows);
      readAnyhow(vtk + "POLYGONS 2 " + text + "\nOFFSETS int\n0 " + text + "\nCONNECTIVITY int\n");
    }
  }
}

/// A file of more faces than indices can name, without the disk space.
TEST(ReaderRobustnessTest, FilesBeyondTheLimitAreRefusedUnread) {
  const TemporaryFolder folder;
  const auto path = folder / "huge.stl";
  store(path, binaryStl(1, UINT32_MAX));
  std::error_code tooLarge;
  std::filesystem::resize_file(path, 84 + 50 * (std::uint64_t{1} << 32U), tooLarge);
  if (tooLarge) GTEST_SKIP() << "no file of 200 GB with a hole here: " << tooLarge.message();
  const AllocationCount count;
  try {
    static_cast<void>(readSurface(path));
    ADD_FAILURE() << "it is read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit) << error.what();
  }
  EXPECT_LT(count.peakBytes(), 100'000U);
}

// One line end per character, endless comments, a million empty statements: all of it linear.
TEST(ReaderRobustnessTest, TimeIsLinear) {
  constexpr std::size_t kMany = 4000000;
  const std::string face = "v 0 0 0\rv 0 0 1\rv 0 1 0\rf 1 2 3\r";
  const auto work = [&] {
    EXPECT_EQ(readAnyhow(face + std::string(kMany, '\r')), 1U);
    EXPECT_EQ(readAnyhow(std::string(kMany, '\r') + face), 1U);
    EXPECT_EQ(readAnyhow(repeated("#\r", kMany / 2) + face), 1U);
    EXPECT_EQ(readAnyhow(face + repeated("\\\r", kMany / 2)), 1U);
    EXPECT_EQ(readAnyhow(repeated("g a\n", kMany / 4) + face), 1U);
  };
  EXPECT_LT(cpuSeconds(work), 20) << "0.2 s on an ordinary machine; hours if it were quadratic";
}

}  // namespace
}  // namespace cutwater::test
