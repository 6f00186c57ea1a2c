#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <algorithm>
#include <set>

#include "Support/OctreeMeshes.hpp"
#include "Support/ParsedVtk.hpp"
#include "Support/Precisions.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class VtuTest : public ::testing::Test {
 protected:
  VtuTest() {
    for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
      const auto& cell = mesh.cells()[n];
      centers.push_back(mesh.center(cell));
      heights.push_back(centers.back().z);
      places.push_back(static_cast<std::uint32_t>(n));
      levels.push_back(cell.level);
    }
  }

  [[nodiscard]] std::vector<VtkArray> arrays() const {
    return {{"height", std::span<const T>(heights)},
            {"center", std::span<const Vec3<T>>(centers)},
            {"place", std::span<const std::uint32_t>(places)},
            {"level", std::span<const std::uint8_t>(levels)}};
  }
  [[nodiscard]] ParsedVtk written(const VtuOptions& options = {}) const {
    writeVtu(folder / "a.vtu", mesh, arrays(), options);
    return ParsedVtk(contentOf(folder / "a.vtu"));
  }

  /// Checks the nodes of every cell. Returns how many are used.
  static std::size_t expectCorners(const Octree<T>& mesh, const std::vector<Vec3<T>>& points,
                                   const std::vector<std::int32_t>& corners) {
    const auto cells = mesh.cells();
    EXPECT_EQ(corners.size(), 8 * cells.size());
    std::vector<bool> isUsed(points.size());
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const auto box = mesh.box(cells[n]);
      for (int c = 0; c < 8; ++c) {  // of a voxel: x fastest
        const auto node = static_cast<std::size_t>(corners.at(8 * n + static_cast<std::size_t>(c)));
        EXPECT_EQ(points.at(node), box.corner(c));
        isUsed[node] = true;
      }
    }
    return static_cast<std::size_t>(std::ranges::count(isUsed, true));
  }

  static std::size_t count(const ParsedVtk& vtu, const std::string& name) {
    return std::stoul(vtu.attribute("Piece", name));
  }

  const std::string type = sizeof(T) == 4 ? "Float32" : "Float64";
  const TemporaryFolder folder;
  const Octree<T> mesh = ballAndPlateMesh<T>(4);
  std::vector<Vec3<T>> centers;
  std::vector<T> heights;
  std::vector<std::uint32_t> places;
  std::vector<std::uint8_t> levels;
};
TYPED_TEST_SUITE(VtuTest, Precisions);

TYPED_TEST(VtuTest, CellsHaveTheirCornersAndShareThem) {
  using T = TypeParam;
  const auto vtu = this->written();
  const auto points = vtu.template array<Vec3<T>>("Points", this->type);
  const auto corners = vtu.template array<std::int32_t>("connectivity", "Int32");
  EXPECT_EQ(this->count(vtu, "NumberOfPoints"), points.size());
  EXPECT_EQ(this->count(vtu, "NumberOfCells"), this->mesh.cells().size());
  EXPECT_EQ(this->expectCorners(this->mesh, points, corners), points.size());
  std::set<std::array<T, 3>> distinct;
  for (const auto& p : points) distinct.insert({p.x, p.y, p.z});
  EXPECT_EQ(distinct.size(), points.size());
}

TYPED_TEST(VtuTest, VolumesSumToTheDomain) {
  using T = TypeParam;
  const auto vtu = this->written();
  const auto points = vtu.template array<Vec3<T>>("Points", this->type);
  const auto corners = vtu.template array<std::int32_t>("connectivity", "Int32");
  const auto ends = vtu.template array<std::int32_t>("offsets", "Int32");
  const auto types = vtu.template array<std::uint8_t>("types", "UInt8");
  ASSERT_EQ(types.size(), this->mesh.cells().size());
  ASSERT_EQ(ends.size(), types.size());
  double sum = 0;
  std::size_t begin = 0;
  for (std::size_t n = 0; n < types.size(); ++n) {
    ASSERT_EQ(types[n], 11);
    ASSERT_EQ(static_cast<std::size_t>(ends[n]), begin + 8);
    const auto at = [&](std::size_t i) {
      return points.at(static_cast<std::size_t>(corners.at(i)));
    };
    const auto size = at(begin + 7) - at(begin);
    sum += double{size.x} * double{size.y} * double{size.z};
    begin += 8;
  }
  const auto all = this->mesh.domain().box().size();
  EXPECT_NEAR(sum, double{all.x} * double{all.y} * double{all.z}, tolerance<T>(18, 4096));
}

TYPED_TEST(VtuTest, ValuesAreReadBackToTheBit) {
  using T = TypeParam;
  const auto vtu = this->written();
  EXPECT_EQ(vtu.attribute("VTKFile", "type"), "UnstructuredGrid");
  EXPECT_EQ(vtu.attribute("VTKFile", "header_type"), "UInt64");
  EXPECT_EQ(vtu.attribute("CellData", "Scalars"), "height");
  EXPECT_EQ(vtu.template array<T>("height", this->type), this->heights);
  EXPECT_EQ(vtu.template array<Vec3<T>>("center", this->type), this->centers);
  EXPECT_EQ(vtu.components("center"), "3");
  EXPECT_EQ(vtu.components("height"), "1");
  EXPECT_EQ(vtu.template array<std::uint32_t>("place", "UInt32"), this->places);
  EXPECT_EQ(vtu.template array<std::uint8_t>("level", "UInt8"), this->levels);
  EXPECT_EQ(vtu.rest(), "\n  </AppendedData>\n</VTKFile>\n");
}

TYPED_TEST(VtuTest, TellsTheNamesOfPatches) {
  const std::vector<std::string> names{"hull", "a<b & \"c\"", "", "R\xC3\xBC\xC3\xA7kseite"};
  const auto vtu = this->written({.patchNames = names});
  EXPECT_EQ(vtu.texts("patch names"), names);
  EXPECT_LT(vtu.header().find("<FieldData>"), vtu.header().find("<Piece "));
  EXPECT_NE(vtu.header().find("NumberOfTuples=\"4\""), std::string::npos);
  EXPECT_EQ(vtu.template array<std::uint8_t>("level", "UInt8"), this->levels);
  EXPECT_EQ(this->written().header().find("FieldData"), std::string::npos);
}

TYPED_TEST(VtuTest, WideIndicesSayTheSame) {
  const auto narrow = this->written();
  const auto wide = this->written({.wideIndices = true});
  for (const std::string name : {"connectivity", "offsets"}) {
    const auto one = narrow.template array<std::int32_t>(name, "Int32");
    const auto other = wide.template array<std::int64_t>(name, "Int64");
    EXPECT_TRUE(std::ranges::equal(one, other));
  }
}

TYPED_TEST(VtuTest, OfManyCellsHasTheSameBytesForAnyNumberOfThreads) {
  using T = TypeParam;
  const auto large = ballAndPlateMesh<T>(6);
  std::vector<std::uint8_t> bytes;  // of more cells than are made in one go
  for (const auto& cell : large.cells()) bytes.push_back(cell.level);
  ASSERT_GT(bytes.size(), std::size_t{1} << 17U);
  const std::array<VtkArray, 1> levelsOnly{VtkArray{"level", std::span<const std::uint8_t>(bytes)}};
  std::set<std::string> contents;
  for (const int threads : {1, 2, 5}) {
    writeVtu(this->folder / "b.vtu", large, levelsOnly, {.threads = threads});
    contents.insert(contentOf(this->folder / "b.vtu"));
  }
  ASSERT_EQ(contents.size(), 1U);
  const ParsedVtk vtu(*contents.begin());
  const auto points = vtu.template array<Vec3<T>>("Points", this->type);
  EXPECT_EQ(
      this->expectCorners(large, points, vtu.template array<std::int32_t>("connectivity", "Int32")),
      points.size());
}

TYPED_TEST(VtuTest, RefusesWhatDoesNotFit) {
  using T = TypeParam;
  const VtkArray good{"d", std::span<const T>(this->heights)};
  const VtkArray shorter{"s", std::span<const T>(this->heights).first(5)};
  const VtkArray nameless{"", std::span<const T>(this->heights)};
  const auto write = [&](std::vector<VtkArray> arrays, const VtuOptions& options = {}) {
    writeVtu(this->folder / "a.vtu", this->mesh, arrays, options);
  };
  EXPECT_THROW(write({}), Error);
  EXPECT_THROW(write({good, shorter}), Error);
  EXPECT_THROW(write({nameless}), Error);
  EXPECT_THROW(write({good, good}), Error);
  EXPECT_THROW(write({good}, {.threads = -1}), Error);
  EXPECT_EQ(this->folder.fileCount(), 0U);
  EXPECT_THROW(writeVtu(this->folder / "no" / "a.vtu", this->mesh, std::span(&good, 1)), Error);
}

}  // namespace
}  // namespace cutwater::test
