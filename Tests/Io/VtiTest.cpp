#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "Support/ParsedVtk.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

const IndexBox kBox{{-2, 0, 5}, {1, 2, 6}};  // 4 x 3 x 2

std::vector<double> ramp(double step) {
  std::vector<double> values(kBox.count());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) * step - 1;
  return values;
}

TEST(VtiTest, CellDataIsReadBackToTheBit) {
  const TemporaryFolder folder;
  const auto distance = ramp(0.1);
  std::vector<float> coarse(distance.begin(), distance.end());
  std::vector<std::uint32_t> ids(kBox.count(), kNone);
  ids[3] = 17;
  std::vector<std::uint64_t> masks(kBox.count(), std::uint64_t{1} << 63U);
  std::vector<std::int32_t> signedIds(kBox.count(), -1);
  signedIds[3] = 17;
  const std::array<VtkArray, 5> arrays{VtkArray{"distance", std::span<const double>(distance)},
                                       {"coarse", std::span<const float>(coarse)},
                                       {"masks", std::span<const std::uint64_t>(masks)},
                                       {"a<b & \"c\"", std::span<const std::uint32_t>(ids)},
                                       {"signed", std::span<const std::int32_t>(signedIds)}};
  const Level<double> level({0.1, -2, 1e-3}, {0.25, 1e-7, 3});
  writeVti(folder / "a.vti", GridPatch<double>{level, kBox}, arrays);

  const ParsedVtk vti(contentOf(folder / "a.vti"));
  EXPECT_EQ(vti.attribute("VTKFile", "type"), "ImageData");
  EXPECT_EQ(vti.attribute("VTKFile", "header_type"), "UInt64");
  EXPECT_EQ(vti.attribute("VTKFile", "byte_order"), "LittleEndian");
  EXPECT_EQ(vti.attribute("ImageData", "WholeExtent"), "-2 2 0 3 5 7");  // points around cells
  EXPECT_EQ(vti.attribute("Piece", "Extent"), "-2 2 0 3 5 7");
  EXPECT_EQ(vti.attribute("ImageData", "Origin"), "0.1 -2 0.001");
  EXPECT_EQ(vti.attribute("ImageData", "Spacing"), "0.25 1e-07 3");
  EXPECT_EQ(vti.attribute("CellData", "Scalars"), "distance");
  EXPECT_EQ(vti.array<double>("distance", "Float64"), distance);
  EXPECT_EQ(vti.array<float>("coarse", "Float32"), coarse);
  EXPECT_EQ(vti.array<std::uint64_t>("masks", "UInt64"), masks);
  EXPECT_EQ(vti.array<std::uint32_t>("a&lt;b &amp; &quot;c&quot;", "UInt32"), ids);
  EXPECT_EQ(vti.array<std::int32_t>("signed", "Int32"), signedIds);
  EXPECT_EQ(vti.rest(), "\n  </AppendedData>\n</VTKFile>\n");
}

TEST(VtiTest, TellsTheNamesOfPatches) {
  const TemporaryFolder folder;
  const std::vector<std::int32_t> ids(kBox.count(), 1);
  const VtkArray patch{"patch", std::span<const std::int32_t>(ids)};
  const GridPatch<double> grid{Level<double>({0, 0, 0}, {1, 1, 1}), kBox};
  const std::vector<std::string> names{"hull", "two words"};
  writeVti(folder / "a.vti", grid, std::span(&patch, 1), {.patchNames = names});
  const ParsedVtk vti(contentOf(folder / "a.vti"));
  EXPECT_EQ(vti.texts("patch names"), names);
  EXPECT_LT(vti.header().find("<FieldData>"), vti.header().find("<Piece "));
  EXPECT_EQ(vti.array<std::int32_t>("patch", "Int32"), ids);
}

TEST(VtiTest, NodesArePointData) {
  const TemporaryFolder folder;
  const auto values = ramp(1);
  const std::array<VtkArray, 1> arrays{VtkArray{"d", std::span<const double>(values)}};
  const Level<float> level({0, 0, 0}, {1, 1, 1}, Centering::Node);
  writeVti(folder / "a.vti", GridPatch<float>{level, kBox}, arrays);
  const ParsedVtk vti(contentOf(folder / "a.vti"));
  EXPECT_EQ(vti.attribute("ImageData", "WholeExtent"), "-2 1 0 2 5 6");
  EXPECT_EQ(vti.attribute("PointData", "Scalars"), "d");
  EXPECT_EQ(vti.header().find("<CellData "), std::string::npos);
  EXPECT_EQ(vti.array<double>("d", "Float64"), values);
}

TEST(VtiTest, RefusesWhatDoesNotFit) {
  const TemporaryFolder folder;
  const Level<double> level({0, 0, 0}, {1, 1, 1});
  const GridPatch<double> gridPatch{level, kBox};
  const auto values = ramp(1);
  const VtkArray good{"d", std::span<const double>(values)};
  const VtkArray shorter{"s", std::span<const double>(values).first(5)};
  const VtkArray nameless{"", std::span<const double>(values)};
  const auto write = [&](const GridPatch<double>& where, std::vector<VtkArray> arrays) {
    writeVti(folder / "a.vti", where, arrays);
  };
  EXPECT_THROW(write(gridPatch, {}), Error);
  EXPECT_THROW(write(gridPatch, {good, shorter}), Error);
  EXPECT_THROW(write(gridPatch, {nameless}), Error);
  EXPECT_THROW(write(gridPatch, {good, good}), Error);
  EXPECT_THROW(write({level, {{0, 0, 0}, {-1, 0, 0}}}, {good}), Error);
  const auto most = std::numeric_limits<std::int32_t>::max();
  EXPECT_THROW(write({level, {{most - 3, 0, 0}, {most, 2, 1}}}, {good}), Error);
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace cutwater::test
