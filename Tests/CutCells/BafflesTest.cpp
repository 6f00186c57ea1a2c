// Sheets without thickness, alone and beside cubes, against a flood of the boxes between all
// planes, those of the grid, of the sheets and of the cubes; and sheets that lie anyhow.

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "Support/CutIdentities.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test::flooded_baffles {
namespace {

constexpr int kSquares = 5;  // along each axis
constexpr int kParts = 4;    // planes of the grid are at multiples of this part of a square

using Place = std::array<int, 3>;

/// A square between two cubes of a lattice: across an axis, below the cube at `place`.
struct Square {
  int axis = 0;
  Place place{};
  bool operator<(const Square& other) const {
    return std::tie(axis, place) < std::tie(other.axis, other.place);
  }
};

struct Scene {
  std::set<Square> squares;
  std::set<Place> cubes;

  [[nodiscard]] PolygonSoup soup() const {
    PolygonSoup result;
    result.patchNames = {"body", "fin"};
    for (const auto& square : squares) add(square, true, 1, result);
    for (const auto& cube : cubes) {
      for (int axis = 0; axis < 3; ++axis) {
        auto above = cube;
        ++above[std::size_t(axis)];
        auto below = cube;
        --below[std::size_t(axis)];
        if (!cubes.contains(above)) add({axis, above}, true, 0, result);
        if (!cubes.contains(below)) add({axis, cube}, false, 0, result);
      }
    }
    weldExactly(result);
    return result;
  }

 private:
  static void add(const Square& square, bool facesUp, std::uint32_t patch, PolygonSoup& soup) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      Vec3<double> p{double(square.place[0]), double(square.place[1]), double(square.place[2])};
      p[(square.axis + 1) % 3] += facesUp ? u : v;
      p[(square.axis + 2) % 3] += facesUp ? v : u;
      soup.points.push_back(p);
    }
    soup.addPolygon(std::array{first, first + 1, first + 2}, patch);
    soup.addPolygon(std::array{first, first + 2, first + 3}, patch);
  }
};

/// The cubes do not touch each other in edges and corners alone.
Scene randomScene(std::mt19937& random) {
  Scene scene;
  const auto place = [&] { return static_cast<int>(random() % kSquares); };
  const auto most = random() % 3 == 0 ? 150U : 30U;
  for (auto n = 2 + random() % most; n > 0; --n) {
    Square square{static_cast<int>(random() % 3), {}};
    for (auto& i : square.place) i = place();
    scene.squares.insert(square);
  }
  if (random() % 2 == 0) {
    Place cube{};
    for (auto& i : cube) i = place();
    scene.cubes.insert(cube);
    ++cube[random() % 3];
    scene.cubes.insert(cube);
  }
  return scene;
}

/// From -1 to beyond the last square, in parts of one.
std::vector<int> randomPlanes(std::mt19937& random, bool isAligned) {
  std::vector<int> planes{-kParts};
  while (planes.back() < (kSquares + 2) * kParts) {
    const int parts = isAligned ? kParts : 1 + static_cast<int>(random() % (2 * kParts));
    planes.push_back(planes.back() + parts);
  }
  return planes;
}

CellPlanes gridOf(const std::array<std::vector<int>, 3>& planes) {
  std::array<std::vector<double>, 3> positions;
  for (std::size_t a = 0; a < 3; ++a) {
    for (const int plane : planes[a]) positions[a].push_back(double(plane) / kParts);
  }
  return cellsBetween(positions);
}

/// What is compared: of each cell the volumes of its pieces and their walls, of each face the area
/// that is open between each two pieces.
struct Found {
  std::map<Place, std::vector<std::array<double, 2>>> cells;
  std::map<std::pair<Place, int>, std::vector<double>> faces;

  void sort() {
    // Up to rounding, which decides between equal ones.
    const auto key = [](const std::array<double, 2>& p) {
      return std::pair(std::round(1e9 * p[0]), p[1]);
    };
    for (auto& [cell, pieces] : cells) std::ranges::sort(pieces, {}, key);
    for (auto& [face, areas] : faces) std::ranges::sort(areas);
  }
};

/// Boxes of one part each.
class Flood {
 public:
  /// `isFlat`: of one layer of boxes, as high as a cube, without what is below and above it.
  Flood(const Scene& scene, const std::array<std::vector<int>, 3>& planes, bool isFlat = false)
      : scene_(scene),
        planes_(planes),
        first_(planes[0].front()),
        axes_(isFlat ? 2 : 3),
        height_(isFlat ? 1 : 1.0 / kParts) {
    for (const auto& p : planes) size_ = std::max(size_, p.back() - first_);
    const auto size = static_cast<std::size_t>(size_);
    sets_.reset(size * size * size);
  }

  Found run() {
    joinBoxes();
    constexpr double kWidth = 1.0 / kParts;
    std::map<Place, std::map<std::uint32_t, std::array<double, 2>>> cells;
    std::map<std::pair<Place, int>, std::map<std::array<std::uint32_t, 2>, double>> faces;
    const auto pieceAt = [&](const Place& box) -> std::array<double, 2>& {
      return cells[cellOf(box)][sets_.find(number(box))];
    };
    forBoxes([&](const Place& box) {
      cells[cellOf(box)];
      if (isFluid(box)) pieceAt(box)[0] += kWidth * kWidth * height_;
      for (int axis = 0; axis < axes_; ++axis) {
        const double area = kWidth * (axis < 2 ? height_ : kWidth);
        const auto below = boxBelow(box, axis);
        if (isOpen(box, axis)) {
          if (isIn(below) && cellOf(below) != cellOf(box)) {
            faces[{cellOf(box), axis}][{sets_.find(number(below)), sets_.find(number(box))}] +=
                area;
          }
          continue;
        }
        if (isFluid(box)) pieceAt(box)[1] += area;
        if (isIn(below) && isFluid(below)) pieceAt(below)[1] += area;
      }
    });
    Found result;
    for (const auto& [cell, pieces] : cells) {
      result.cells[cell];
      for (const auto& [root, sums] : pieces) result.cells[cell].push_back(sums);
    }
    for (const auto& [face, arcs] : faces) {
      for (const auto& [pieces, area] : arcs) result.faces[face].push_back(area);
    }
    result.sort();
    return result;
  }

 private:
  void joinBoxes() {
    forBoxes([&](const Place& box) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto below = boxBelow(box, axis);
        if (isIn(below) && cellOf(below) == cellOf(box) && isOpen(box, axis)) {
          sets_.unite(number(below), number(box));
        }
      }
    });
  }
  template <typename Visit>
  void forBoxes(Visit&& visit) const {
    for (int k = planes_[2].front(); k < planes_[2].back(); ++k) {
      for (int j = planes_[1].front(); j < planes_[1].back(); ++j) {
        for (int i = planes_[0].front(); i < planes_[0].back(); ++i) visit(Place{i, j, k});
      }
    }
  }
  static Place boxBelow(Place box, int axis) {
    --box[std::size_t(axis)];
    return box;
  }
  [[nodiscard]] bool isIn(const Place& box) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (box[a] < planes_[a].front()) return false;
    }
    return true;
  }
  [[nodiscard]] std::uint32_t number(const Place& box) const {
    return static_cast<std::uint32_t>(((box[2] - first_) * size_ + box[1] - first_) * size_ +
                                      box[0] - first_);
  }
  [[nodiscard]] Place cellOf(const Place& box) const {
    Place cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      cell[a] =
          static_cast<int>(std::ranges::upper_bound(planes_[a], box[a]) - planes_[a].begin()) - 1;
    }
    return cell;
  }
  static Place latticePlace(const Place& box) {
    Place place{};
    for (std::size_t a = 0; a < 3; ++a) place[a] = (box[a] + 8 * kParts) / kParts - 8;  // floor
    return place;
  }
  [[nodiscard]] bool isFluid(const Place& box) const {
    return !scene_.cubes.contains(latticePlace(box));
  }
  /// Whether there is fluid in a box and in the one below it, and no square between them.
  [[nodiscard]] bool isOpen(const Place& box, int axis) const {
    if (!isFluid(box) || !isFluid(boxBelow(box, axis))) return false;
    return box[std::size_t(axis)] % kParts != 0 ||
           !scene_.squares.contains({axis, latticePlace(box)});
  }

  const Scene& scene_;
  const std::array<std::vector<int>, 3>& planes_;
  int first_;
  int axes_;
  double height_;
  int size_ = 0;
  detail::DisjointSets sets_;
};

Found foundIn(const CutCells& cells) {
  Found result;
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    const auto& c = cells.cells.index[row];
    auto& pieces = result.cells[{c.i, c.j, c.k}];
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      pieces.push_back({cells.pieces.volume[p], cells.pieces.wallArea[p]});
    }
  }
  std::map<std::pair<Place, int>, std::map<std::array<std::uint32_t, 2>, double>> sums;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& c = cells.arcs.cell[a];
    sums[{{c.i, c.j, c.k}, cells.arcs.axis[a]}][{cells.arcs.below[a], cells.arcs.above[a]}] +=
        cells.arcs.area[a];
  }
  for (const auto& [face, arcs] : sums) {
    for (const auto& [pieces, area] : arcs) result.faces[face].push_back(area);
  }
  result.sort();
  return result;
}

void expectFlooded(const CutCells& cells, Found flooded) {
  const auto found = foundIn(cells);
  for (const auto& [cell, expected] : flooded.cells) {
    const auto what = testing::PrintToString(cell);
    const auto there = found.cells.find(cell);
    if (there == found.cells.end()) {
      EXPECT_TRUE(expected.empty() || (expected.size() == 1 && expected[0][1] == 0)) << what;
      continue;
    }
    ASSERT_EQ(there->second.size(), expected.size()) << what;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(there->second[i][0], expected[i][0], 1e-12) << what;
      ASSERT_NEAR(there->second[i][1], expected[i][1], 1e-12) << what;
    }
  }
  for (const auto& [face, areas] : found.faces) {
    const auto& expected = flooded.faces[face];
    if (expected.empty()) continue;  // at the rim of the grid
    const auto what = testing::PrintToString(face);
    ASSERT_EQ(areas.size(), expected.size()) << what;
    for (std::size_t i = 0; i < areas.size(); ++i)
      ASSERT_NEAR(areas[i], expected[i], 1e-12) << what;
  }
}

/// Calls visit(random, scene, isAligned, cutter) for random scenes, until one fails.
template <typename Visit>
void forScenes(unsigned seed, int rounds, Visit&& visit) {
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round) {
    const auto scene = randomScene(random);
    const bool isAligned = random() % 3 == 0;
    const Solid<double> solid(MeshSDF<double>(scene.soup()));
    visit(random, scene, isAligned, CellCutter(solid, FluidSide::Outside, {.baffles = {"fin"}}));
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << round;
      return;
    }
  }
}

TEST(BafflesTest, SquaresAndCubesAreThoseOfAFlood) {
  std::size_t several = 0;
  forScenes(3, scaled(150),
            [&](auto& random, const Scene& scene, bool isAligned, const auto& cutter) {
              std::array<std::vector<int>, 3> planes;
              for (auto& p : planes) p = randomPlanes(random, isAligned);
              const auto cells = cutter.cut(gridOf(planes), {.polygons = true, .moments = 1});
              expectFlooded(cells, Flood(scene, planes).run());
              expectIdentities(cells, 1e-13);
              expectPolygonsOf(cells);
              several += check(cells).multiPieceCells;
            });
  EXPECT_GT(several, 300U);
}

TEST(BafflesTest, InPlanesAreThoseOfAFlood) {
  std::size_t several = 0;
  forScenes(5, scaled(100),
            [&](auto& random, const Scene& scene, bool isAligned, const auto& cutter) {
              std::array<std::vector<int>, 3> planes;
              for (const std::size_t a : {0, 1}) planes[a] = randomPlanes(random, isAligned);
              const int layer = -1 + static_cast<int>(random() % (kParts * kSquares));
              planes[2] = {layer, layer + 1};
              const auto cells = cutter.cutInPlane(gridOf(planes), (layer + 0.5) / kParts);
              expectFlooded(cells, Flood(scene, planes, true).run());
              expectIdentities(cells, 1e-13);
              several += check(cells).multiPieceCells;
            });
  EXPECT_GT(several, 60U);
}

}  // namespace
}  // namespace cutwater::test::flooded_baffles
