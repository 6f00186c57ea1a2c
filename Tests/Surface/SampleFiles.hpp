#pragma once

#include <Cutwater/Surface/WriteSurface.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "SurfaceFiles.hpp"

#ifdef CUTWATER_HAS_ZLIB
#include <zlib.h>
#endif

namespace cutwater::test {

/// A folder of its own for each test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    path_ = std::filesystem::path(::testing::TempDir()) /
            (std::string("cutwater-") + test->test_suite_name() + "-" + test->name() + "-" +
             std::to_string(++count));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  [[nodiscard]] std::size_t fileCount() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void store(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

#ifdef CUTWATER_HAS_ZLIB
inline std::string gzip(const std::string& bytes) {
  z_stream stream{};
  constexpr int kGzip = 16;
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + kGzip, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}
#endif

struct Sample {
  std::string name;
  std::string bytes;
};

/// A tetrahedron in a small valid file of every format and encoding.
inline std::vector<Sample> sampleFiles() {
  const TemporaryFolder folder;
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1.5, 0, 0}, {0, 1, 0}, {0, 0, 0.25}};
  soup.patchNames = {"a", "b"};
  for (const std::uint32_t skipped : {0U, 1U, 2U, 3U}) {
    std::array<std::uint32_t, 3> face{};
    for (std::uint32_t i = 0; i < 3; ++i) face[i] = (skipped + i + 1) % 4;
    soup.addPolygon(face, skipped / 2);
  }
  std::vector<Sample> samples;
  for (const auto& [name, ascii] : {std::pair{"binary.stl", false},
                                    {"ascii.stl", true},
                                    {"binary.ply", false},
                                    {"ascii.ply", true},
                                    {"text.obj", true},
                                    {"text.off", true}}) {
    writeSurface(folder / name, soup, {.ascii = ascii});
    samples.push_back({name, contentOf(folder / name)});
  }
  const std::string points = "POINTS 4 float\n0 0 0 1.5 0 0 0 1 0 0 0 0.25\n";
  const std::string begin = "# vtk DataFile Version ";
  samples.push_back({"ascii3.vtk", begin + "3.0\nx\nASCII\nDATASET POLYDATA\n" + points +
                                       "POLYGONS 2 8\n3 0 1 2\n3 0 1 3\nTRIANGLE_STRIPS 1 5\n"
                                       "4 0 1 2 3\n"});
  samples.push_back({"ascii5.vtk", begin + "5.1\nx\nASCII\nDATASET POLYDATA\n" + points +
                                       "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\n"
                                       "CONNECTIVITY vtktypeint64\n0 1 2 0 1 3\n"});
  for (const bool offsets : {false, true}) {
    ByteWriter file(std::endian::big);
    file.text(begin + (offsets ? "5.1" : "3.0") + "\nx\nBINARY\nDATASET POLYDATA\n");
    file.text("POINTS 4 float\n");
    file.numbers<float>({0, 0, 0, 1.5, 0, 0, 0, 1, 0, 0, 0, 0.25}).text("\n");
    if (offsets) {
      file.text("POLYGONS 3 6\nOFFSETS vtktypeint64\n").numbers<std::int64_t>({0, 3, 6});
      file.text("\nCONNECTIVITY vtktypeint64\n").numbers<std::int64_t>({0, 1, 2, 0, 1, 3});
    } else {
      file.text("POLYGONS 2 8\n").numbers<std::int32_t>({3, 0, 1, 2, 3, 0, 1, 3});
    }
    samples.push_back({offsets ? "binary5.vtk" : "binary3.vtk", file.text("\n").bytes()});
  }
  ByteWriter big(std::endian::big);
  big.text(
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty uchar red\n"
      "property list uchar uint vertex_indices\nend_header\n");
  big.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).numbers<std::uint8_t>({255, 3});
  samples.push_back({"big.ply", big.numbers<std::uint32_t>({0, 1, 2}).bytes()});
#ifdef CUTWATER_HAS_ZLIB
  samples.push_back({"ascii.stl.gz", gzip(samples[1].bytes)});
  samples.push_back({"binary.stl.gz", gzip(samples[0].bytes)});
#endif
  return samples;
}

}  // namespace cutwater::test
