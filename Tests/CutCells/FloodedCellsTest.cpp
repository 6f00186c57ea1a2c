// Cut cells of solids made of cubes, beside a flood of the boxes between all planes, those of the
// grid and those of the cubes. Sizes are multiples of powers of 2, so the flood is exact.

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

constexpr int kCubes = 12;  // along each axis; those at the rim are not in the solid
constexpr double kCube = 1.0 / 16;
/// Planes of the grid are at multiples of this part of a cube.
constexpr int kParts = 8;

using Place = VoxelSolid::Place;
/// Sums as whole numbers, in which nothing is lost.
using Row = std::vector<std::int64_t>;

std::int64_t whole(double x) {
  return std::llround(std::ldexp(x, 36));
}

VoxelSolid randomCubes(std::mt19937& random, bool isTight) {
  VoxelSolid solid(kCube);
  const auto share = 15 + random() % 70;  // in hundredths
  for (int x = 1; x < kCubes - 1; ++x) {
    for (int y = 1; y < kCubes - 1; ++y) {
      for (int z = 1; z < kCubes - 1; ++z) {
        if (random() % 100 < share) solid.add({x, y, z});
      }
    }
  }
  solid.add({kCubes / 2, kCubes / 2, kCubes / 2});
  if (isTight) solid.close(kCubes - 1);
  return solid;
}

/// From 0 to the last cube, in parts of a cube; `isAligned`: all in planes of cubes.
std::vector<int> randomPlanes(std::mt19937& random, bool isAligned) {
  std::vector<int> planes{0};
  while (planes.back() < kCubes * kParts) {
    const int cubes = 1 + static_cast<int>(random() % 4);
    const int parts = isAligned ? 0 : static_cast<int>(random() % kParts);
    planes.push_back(std::min(planes.back() + cubes * kParts + parts, kCubes * kParts));
  }
  return planes;
}

/// The fluid between all planes.
class Flood {
 public:
  Flood(const VoxelSolid& solid, const std::array<std::vector<int>, 3>& grid, FluidSide side) {
    for (std::size_t a = 0; a < 3; ++a) {
      planes_[a] = grid[a];
      for (int n = 0; n <= kCubes; ++n) planes_[a].push_back(n * kParts);
      std::ranges::sort(planes_[a]);
      planes_[a].erase(std::unique(planes_[a].begin(), planes_[a].end()), planes_[a].end());
      for (std::size_t n = 0; n + 1 < planes_[a].size(); ++n) {
        const auto above = std::ranges::upper_bound(grid[a], planes_[a][n]);
        cellOf_[a].push_back(static_cast<int>(above - grid[a].begin()) - 1);
      }
    }
    const auto n = sizes();
    isFluid_.resize(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
                    static_cast<std::size_t>(n[2]));
    forBoxes([&](const Place& p) {
      Place cube{};
      for (std::size_t a = 0; a < 3; ++a) cube[a] = planes_[a][index(p[a])] / kParts;
      isFluid_[number(p)] = solid.has(cube) == (side == FluidSide::Inside) ? 1 : 0;
    });
    sets_.reset(isFluid_.size());
    forBoxes([&](const Place& p) {
      for (std::size_t a = 0; a < 3; ++a) {
        const auto next = above(p, a);
        if (isFluid(p) && isFluid(next) && cell(p) == cell(next)) {
          sets_.unite(number(p), number(next));
        }
      }
    });
    sumPieces();
    sumArcs();
  }

  /// Of a cell's pieces: volume, its first moment, area and vector of the wall.
  [[nodiscard]] std::vector<Row> pieces(const Place& cell) const { return sorted(pieces_, cell); }
  /// Of the open parts of the face below a cell: area, its first moment, and the volumes of the
  /// pieces below and above.
  [[nodiscard]] std::vector<Row> arcs(const Place& cell, std::size_t axis) const {
    return sorted(arcs_[axis], cell);
  }

 private:
  using Sums = std::map<std::uint32_t, std::vector<double>>;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Place sizes() const {
    Place n{};
    for (std::size_t a = 0; a < 3; ++a) n[a] = static_cast<int>(planes_[a].size()) - 1;
    return n;
  }
  [[nodiscard]] std::uint32_t number(const Place& p) const {
    const auto n = sizes();
    return static_cast<std::uint32_t>((p[2] * n[1] + p[1]) * n[0] + p[0]);
  }
  template <typename Visit>
  void forBoxes(Visit&& visit) const {
    const auto n = sizes();
    for (int z = 0; z < n[2]; ++z) {
      for (int y = 0; y < n[1]; ++y) {
        for (int x = 0; x < n[0]; ++x) visit(Place{x, y, z});
      }
    }
  }
  static Place above(Place p, std::size_t axis) {
    ++p[axis];
    return p;
  }
  [[nodiscard]] bool isIn(const Place& p) const {
    const auto n = sizes();
    return p[0] < n[0] && p[1] < n[1] && p[2] < n[2];
  }
  [[nodiscard]] bool isFluid(const Place& p) const { return isIn(p) && isFluid_[number(p)] != 0; }
  [[nodiscard]] Place cell(const Place& p) const {
    return {cellOf_[0][index(p[0])], cellOf_[1][index(p[1])], cellOf_[2][index(p[2])]};
  }
  [[nodiscard]] double at(std::size_t axis, int plane) const {
    return planes_[axis][index(plane)] * (kCube / kParts);
  }
  [[nodiscard]] double width(const Place& p, std::size_t axis) const {
    return at(axis, p[axis] + 1) - at(axis, p[axis]);
  }
  [[nodiscard]] double faceArea(const Place& p, std::size_t axis) const {
    return width(p, (axis + 1) % 3) * width(p, (axis + 2) % 3);
  }
  [[nodiscard]] double middle(const Place& p, std::size_t axis) const {
    return 0.5 * (at(axis, p[axis]) + at(axis, p[axis] + 1));
  }

  void sumPieces() {
    forBoxes([&](const Place& p) {
      for (std::size_t a = 0; a < 3; ++a) {
        const auto next = above(p, a);
        if (!isIn(next) || isFluid(p) == isFluid(next)) continue;
        const auto& fluid = isFluid(p) ? p : next;
        auto& sum = pieceAt(fluid);
        sum[4] += faceArea(p, a);
        sum[5 + a] += (isFluid(p) ? 1 : -1) * faceArea(p, a);
      }
      if (!isFluid(p)) return;
      const double volume = width(p, 0) * faceArea(p, 0);
      auto& sum = pieceAt(p);
      sum[0] += volume;
      for (std::size_t a = 0; a < 3; ++a) sum[1 + a] += volume * middle(p, a);
    });
  }
  std::vector<double>& pieceAt(const Place& p) {
    auto& sum = pieces_[cell(p)][sets_.find(number(p))];
    sum.resize(8);
    return sum;
  }
  void sumArcs() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      detail::DisjointSets faces(isFluid_.size());  // by the box above
      const auto isOpen = [&](const Place& p) {
        if (!isIn(p) || p[axis] == 0 || !isFluid(p)) return false;
        auto below = p;
        --below[axis];
        return isFluid(below) && cell(below) != cell(p);
      };
      forBoxes([&](const Place& p) {
        for (const std::size_t along : {(axis + 1) % 3, (axis + 2) % 3}) {
          const auto next = above(p, along);
          if (isOpen(p) && isOpen(next) && cell(p) == cell(next)) {
            faces.unite(number(p), number(next));
          }
        }
      });
      forBoxes([&](const Place& p) {
        if (!isOpen(p)) return;
        auto below = p;
        --below[axis];
        auto& sum = arcs_[axis][cell(p)][faces.find(number(p))];
        sum.resize(6);
        sum[0] += faceArea(p, axis);
        for (std::size_t a = 0; a < 3; ++a) {
          sum[1 + a] += faceArea(p, axis) * (a == axis ? at(a, p[a]) : middle(p, a));
        }
        sum[4] = pieceAt(below)[0];
        sum[5] = pieceAt(p)[0];
      });
    }
  }
  [[nodiscard]] static std::vector<Row> sorted(const std::map<Place, Sums>& of, const Place& cell) {
    std::vector<Row> rows;
    const auto found = of.find(cell);
    if (found == of.end()) return rows;
    for (const auto& [root, sums] : found->second) {
      auto& row = rows.emplace_back();
      for (const double x : sums) row.push_back(whole(x));
    }
    std::ranges::sort(rows);
    return rows;
  }

  std::array<std::vector<int>, 3> planes_;  // in parts of a cube
  std::array<std::vector<int>, 3> cellOf_;
  std::vector<char> isFluid_;
  detail::DisjointSets sets_;
  std::map<Place, Sums> pieces_;
  std::array<std::map<Place, Sums>, 3> arcs_;
};

std::vector<Row> piecesOf(const CutCells& cells, std::uint32_t row) {
  std::vector<Row> rows;
  for (auto n = cells.cells.firstPiece[row]; n < cells.cells.firstPiece[row + 1]; ++n) {
    const auto moment = cells.pieces.volume[n] * cells.pieces.centroid[n];
    const auto& wall = cells.pieces.wallVector[n];
    rows.push_back({whole(cells.pieces.volume[n]), whole(moment.x), whole(moment.y),
                    whole(moment.z), whole(cells.pieces.wallArea[n]), whole(wall.x), whole(wall.y),
                    whole(wall.z)});
  }
  std::ranges::sort(rows);
  return rows;
}

/// By face: the cell above it and the axis across it.
using ArcRows = std::map<std::pair<Place, std::size_t>, std::vector<Row>>;

/// Of the faces within the box that have any.
ArcRows arcsOf(const CutCells& cells) {
  ArcRows result;
  for (std::size_t n = 0; n < cells.arcs.area.size(); ++n) {
    const auto& above = cells.arcs.cell[n];
    const auto below = cells.arcs.cellBelow(n);
    if (!cells.grid.indices().contains(above) || !cells.grid.indices().contains(below)) continue;
    const auto volumeOf = [&](std::uint32_t piece, const Index3& cell) {
      return whole(piece == CutCells::kWholeCell ? cells.cellVolume(cell)
                                                 : cells.pieces.volume.at(piece));
    };
    const auto moment = cells.arcs.area[n] * cells.arcs.centroid[n];
    result[{{above.i, above.j, above.k}, cells.arcs.axis[n]}].push_back(
        {whole(cells.arcs.area[n]), whole(moment.x), whole(moment.y), whole(moment.z),
         volumeOf(cells.arcs.below[n], below), volumeOf(cells.arcs.above[n], above)});
  }
  for (auto& [face, rows] : result) std::ranges::sort(rows);
  return result;
}

/// Rows of arcs whose pieces have the same volumes, added up: parts of a face that touch in a
/// vertex are one or two.
std::vector<Row> addedUp(const std::vector<Row>& arcs) {
  std::map<Row, Row> sums;
  for (const auto& row : arcs) {
    auto& sum = sums[{row.begin() + 4, row.end()}];
    sum.resize(4);
    for (std::size_t i = 0; i < 4; ++i) sum[i] += row[i];
  }
  std::vector<Row> result;
  for (const auto& [pieces, sum] : sums) result.push_back(sum);
  return result;
}

/// Of cells.
struct Counts {
  std::size_t all = 0;
  std::size_t several = 0;  ///< with several pieces
  std::size_t meeting = 0;
};

/// Of the faces below a cell.
void expectFloodedFaces(const CutCells& cells, const ArcRows& arcs, const Flood& flood,
                        const Index3& at, bool isTight) {
  const auto hasRow = [&](const Index3& cell) { return cells.rowOf(cell) != CutCells::kNoRow; };
  const Place place{at.i, at.j, at.k};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto below = at;
    --(axis == 0 ? below.i : axis == 1 ? below.j : below.k);
    if (!cells.grid.indices().contains(below) || (!hasRow(at) && !hasRow(below))) continue;
    const auto there = arcs.find({place, axis});
    const auto found = there != arcs.end() ? there->second : std::vector<Row>{};
    const auto flooded = flood.arcs(place, axis);
    const std::string what = testing::PrintToString(place) + " axis " + std::to_string(axis);
    if (isTight) {
      EXPECT_EQ(found, flooded) << what;
    } else {
      EXPECT_EQ(addedUp(found), addedUp(flooded)) << what;
    }
  }
}

/// `surface`: of the cubes.
void expectFlooded(const Solid<double>& surface, const VoxelSolid& solid,
                   const std::array<std::vector<int>, 3>& planes, bool isTight, Counts& counts,
                   FluidSide side = FluidSide::Outside) {
  std::array<std::vector<double>, 3> positions;
  for (std::size_t a = 0; a < 3; ++a) {
    for (const int plane : planes[a]) positions[a].push_back(plane * (kCube / kParts));
  }
  const auto cells = CellCutter(surface, side).cut(cellsBetween(positions));
  const Flood flood(solid, planes, side);
  const auto arcs = arcsOf(cells);
  const auto box = cells.grid.indices();
  for (std::size_t n = 0; n < box.count(); ++n) {
    const auto length = [&](int axis) { return static_cast<std::size_t>(box.length(axis)); };
    const auto at = box.at(static_cast<std::uint32_t>(n % length(0)),
                           static_cast<std::uint32_t>(n / length(0) % length(1)),
                           static_cast<std::uint32_t>(n / length(0) / length(1)));
    const Place place{at.i, at.j, at.k};
    const auto expected = flood.pieces(place);
    ++counts.all;
    if (const auto row = cells.rowOf(at); row != CutCells::kNoRow) {
      EXPECT_EQ(piecesOf(cells, row), expected) << n;
      counts.several += expected.size() > 1 ? 1 : 0;
      counts.meeting += cells.cells.meets[row];
    } else if (cells.classOf(at) == FluidClass::Body) {
      EXPECT_TRUE(expected.empty()) << n;
    } else {
      ASSERT_EQ(expected.size(), 1U) << n;
      EXPECT_EQ(expected[0][0], whole(cells.cellVolume(at)));
      EXPECT_EQ(expected[0][4], 0) << n;
    }
    expectFloodedFaces(cells, arcs, flood, at, isTight);
  }
}

void expectFlooded(bool isTight, bool isAligned, int rounds) {
  std::mt19937 random(41);
  Counts counts;
  for (int n = 0; n < rounds && !testing::Test::HasFailure(); ++n) {
    const auto solid = randomCubes(random, isTight);
    std::array<std::vector<int>, 3> planes;
    for (auto& ofAxis : planes) ofAxis = randomPlanes(random, isAligned);
    expectFlooded(Solid<double>(meshOf(solid)), solid, planes, isTight, counts);
  }
  const auto least = static_cast<std::size_t>(rounds);
  EXPECT_GT(counts.all, 30 * least);
  EXPECT_GT(counts.several, 4 * least);
  EXPECT_EQ(counts.meeting > 0, !isTight);
}

TEST(FloodedCellsTest, OfCubesInPlanesOfTheGrid) {
  expectFlooded(true, true, scaled(40));
}

TEST(FloodedCellsTest, OfCubesBetweenThem) {
  expectFlooded(true, false, scaled(40));
}

TEST(FloodedCellsTest, OfCubesThatTouchInEdgesAndVertices) {
  expectFlooded(false, true, scaled(10));
  expectFlooded(false, false, scaled(10));
}

TEST(FloodedCellsTest, OfBoxesInContact) {
  std::mt19937 random(43);
  Counts counts;
  for (int n = 0; n < scaled(60) && !HasFailure(); ++n) {
    const auto boxes = boxesInContact(random, 2 + n % 2, kCubes);
    VoxelSolid solid(kCube);
    PolygonSoup soup;
    for (const auto& [lower, upper] : boxes) {
      soup = joined({soup, tessellation::box(kCube * lower, kCube * upper)});
      for (int z = 1; z < kCubes; ++z) {
        for (int y = 1; y < kCubes; ++y) {
          for (int x = 1; x < kCubes; ++x) {
            const Vec3<double> middle{x + 0.5, y + 0.5, z + 0.5};
            if (Box<double>{lower, upper}.contains(middle)) solid.add({x, y, z});
          }
        }
      }
    }
    std::array<std::vector<int>, 3> planes;
    for (auto& ofAxis : planes) ofAxis = randomPlanes(random, n % 3 != 0);
    const Solid<double> surface{MeshSDF<double>(soup)};
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      SCOPED_TRACE(n);
      expectFlooded(surface, solid, planes, false, counts, side);
    }
  }
  EXPECT_GT(counts.meeting, 100U);
}

}  // namespace
}  // namespace cutwater::test
