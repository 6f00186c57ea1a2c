// Rows are the same bytes with any number of threads, in any box and on every instruction set.

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Simd/InstructionSet.hpp>

#include <array>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

constexpr double kWidth = 1.0 / 24;
const std::array kOptions{CutOptions{}, CutOptions{.polygons = true}, CutOptions{.moments = 3}};

/// A smooth surface, walls in planes of the grid, and shells that overlap.
std::vector<Solid<double>> solids() {
  std::mt19937 random(12);
  std::vector<Solid<double>> result{turnedTorus()};
  result.emplace_back(meshOf(randomVoxels(random)));
  result.push_back(solidOf(joined({ball(0.2, kMiddle, 2), ball(0.2, {0.6, 0.55, 0.4}, 2),
                                   tessellation::box({0.125, 0.125, 0.25}, {0.75, 0.5, 0.5})})));
  return result;
}

GridPatch<double> boxOfCells(const Index3& lo, const Index3& hi) {
  return {Level<double>({0, 0, 0}, {kWidth, kWidth, kWidth}), {lo, hi}};
}

template <typename Cut>
std::uint64_t hashOf(const Cut& cut) {
  return checksum(toBytes(cut));
}

TEST(SameBitsTest, ThreadsDoNotMatter) {
  std::mt19937 random(13);
  const auto mesh = dividedMesh(random, 4, 0, 1);
  for (const auto& solid : solids()) {
    const CellCutter cutter(solid);
    for (auto options : kOptions) {
      std::array<std::uint64_t, 2> first{};
      for (const int threads : {1, 2, 5}) {
        options.threads = threads;
        const std::array found{hashOf(cutter.cut(boxOfCells({0, 0, 0}, {23, 23, 23}), options)),
                               hashOf(cutter.cut(mesh, options))};
        if (threads == 1) first = found;
        EXPECT_EQ(found, first) << threads;
      }
    }
    const auto grid = planesOf(boxOfCells({0, 0, 0}, {23, 23, 0}));
    const auto flat = hashOf(cutter.cutInPlane(grid, 0.3, {.threads = 1}));
    for (const int threads : {2, 5}) {
      EXPECT_EQ(hashOf(cutter.cutInPlane(grid, 0.3, {.threads = threads})), flat);
    }
  }
}

using Numbers = std::vector<double>;

void addVector(const Vec3<double>& v, Numbers& to) {
  to.insert(to.end(), {v.x, v.y, v.z});
}
template <typename Values>
void addValues(const Values& values, Numbers& to) {
  for (const auto& value : values) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      to.push_back(value);
    } else {
      addVector(value, to);
    }
  }
}

/// Which of its cell's pieces one is, or what stands in its place.
double ordinal(const CutCells& cells, std::uint32_t side) {
  if (side >= cells.pieces.cell.size()) return -1.0 * (side - CutCells::kBeyond + 1);
  return side - cells.cells.firstPiece[cells.pieces.cell[side]];
}

void addNumbersOfPiece(const CutCells& cells, std::uint32_t p, Numbers& to) {
  const auto& pieces = cells.pieces;
  to.push_back(pieces.volume[p]);
  to.push_back(pieces.wallArea[p]);
  to.push_back(pieces.wallFaces[p]);
  for (const auto& v : {pieces.centroid[p], pieces.wallVector[p], pieces.wallCentroid[p]}) {
    addVector(v, to);
  }
  if (cells.moments.degree >= 0) {
    addValues(cells.moments.ofVolume(p), to);
    addValues(cells.moments.ofWall(p), to);
    addValues(cells.moments.ofWallVector(p), to);
  }
  const auto& parts = cells.wallParts;
  for (std::size_t n = 0; n < parts.piece.size(); ++n) {
    if (parts.piece[n] != p) continue;
    to.push_back(parts.patch[n]);
    to.push_back(parts.area[n]);
    addVector(parts.vector[n], to);
    addVector(parts.centroid[n], to);
    if (cells.firstWallPolygon.empty()) continue;
    for (auto i = cells.firstWallPolygon[n]; i < cells.firstWallPolygon[n + 1]; ++i) {
      addValues(cells.wallPolygons.of(i), to);
    }
  }
}

void addNumbersOfArc(const CutCells& cells, std::size_t a, Numbers& to) {
  to.push_back(cells.arcs.axis[a]);
  to.push_back(cells.arcs.area[a]);
  to.push_back(ordinal(cells, cells.arcs.below[a]));
  to.push_back(ordinal(cells, cells.arcs.above[a]));
  addVector(cells.arcs.centroid[a], to);
  if (cells.moments.degree >= 0) addValues(cells.moments.ofArc(a), to);
  if (!cells.firstWallPolygon.empty()) addValues(cells.arcPolygons.of(a), to);
}

using CellKey = std::array<int, 3>;
CellKey keyOfCell(const Index3& cell) {
  return {cell.i, cell.j, cell.k};
}

/// All that is said of each cell of the box that is cut, and of its faces.
std::map<CellKey, Numbers> cellContents(const CutCells& cells) {
  std::map<CellKey, Numbers> result;
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    auto& numbers = result[keyOfCell(cells.cells.index[row])];
    numbers = {double(cells.cells.fluidCorners[row]), double(cells.cells.meets[row])};
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      addNumbersOfPiece(cells, p, numbers);
    }
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    for (const auto& cell : {cells.arcs.cellBelow(a), cells.arcs.cell[a]}) {
      if (cells.rowOf(cell) != CutCells::kNoRow) addNumbersOfArc(cells, a, result[keyOfCell(cell)]);
    }
  }
  return result;
}

/// Tiles begin at the box's lowest cell, so each box has others.
TEST(SameBitsTest, BoxesDoNotMatter) {
  for (const auto& solid : solids()) {
    const CellCutter cutter(solid);
    for (const auto& options : kOptions) {
      const auto whole = cellContents(cutter.cut(boxOfCells({0, 0, 0}, {23, 23, 23}), options));
      std::size_t compared = 0;
      for (const Index3 lo : {Index3{3, 0, 5}, Index3{10, 7, 1}, Index3{6, 11, 9}}) {
        const Index3 hi{lo.i + 12, lo.j + 9, lo.k + 6};
        const auto part = cellContents(cutter.cut(boxOfCells(lo, hi), options));
        compared += part.size();
        for (const auto& [cell, numbers] : part) {
          const auto found = whole.find(cell);
          ASSERT_NE(found, whole.end());
          ASSERT_EQ(numbers, found->second);
        }
      }
      EXPECT_GT(compared, 100U);
    }
  }
}

/// Of all solids, with all options: one number.
std::uint64_t hashOfAll() {
  std::vector<std::uint64_t> hashes;
  std::mt19937 random(14);
  const auto mesh = dividedMesh(random, 4, 0, 1);
  for (const auto& solid : solids()) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const CellCutter cutter(solid, side);
      for (const auto& options : kOptions) {
        hashes.push_back(hashOf(cutter.cut(boxOfCells({0, 0, 0}, {23, 23, 23}), options)));
        hashes.push_back(hashOf(cutter.cut(mesh, options)));
      }
      hashes.push_back(
          hashOf(cutter.cutInPlane(planesOf(boxOfCells({0, 0, 0}, {23, 23, 0})), 0.3)));
    }
  }
  return checksum(std::as_bytes(std::span(hashes)));
}

/// For the test below, which runs it on each instruction set.
TEST(SameBitsTest, TellTheirHash) {
  const auto hash = hashOfAll();
  EXPECT_EQ(hash, hashOfAll());
  std::cout << "rows on " << name(instructionSet()) << ": " << hash << '\n';
}

/// What this program prints of its rows on an instruction set.
std::string rowsOn(const std::string& set) {
  std::array<char, 4096> path{};
  EXPECT_GT(readlink("/proc/self/exe", path.data(), path.size() - 1), 0);
  const auto command = "CUTWATER_INSTRUCTION_SET=" + set + " '" + path.data() +
                       "' --gtest_filter=SameBitsTest.TellTheirHash";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string output;
  std::array<char, 256> line{};
  while (pipe && std::fgets(line.data(), line.size(), pipe.get()) != nullptr) {
    if (std::string_view(line.data()).starts_with("rows on ")) output += line.data();
  }
  return output;
}

TEST(SameBitsTest, InstructionSetsDoNotMatter) {
  const auto hash = std::to_string(hashOfAll());
  EXPECT_EQ(rowsOn("portable"), "rows on portable: " + hash + "\n");
  EXPECT_EQ(rowsOn("baseline"), "rows on baseline: " + hash + "\n");
  for (const std::string set : {"avx2", "avx512"}) {  // or what the processor has
    const auto found = rowsOn(set);
    EXPECT_TRUE(found.ends_with(": " + hash + "\n")) << found;
  }
}

}  // namespace
}  // namespace cutwater::test
