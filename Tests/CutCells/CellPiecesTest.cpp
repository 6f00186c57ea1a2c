#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "Support/CutTile.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

IndexedTriangles trianglesOf(const PolygonSoup& soup) {
  const auto whole = triangulated(soup);
  IndexedTriangles result{.positions = whole.points, .triangles = {}};
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    const auto corners = whole.polygon(i);
    result.triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return result;
}

/// Turned by angles that nobody chooses, and moved.
IndexedTriangles placed(IndexedTriangles surface, const Vec3<double>& by) {
  for (auto& p : surface.positions) {
    p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
    p = {p.x, 0.28 * p.y - 0.96 * p.z, 0.96 * p.y + 0.28 * p.z};
    p += by;
  }
  return surface;
}

void add(IndexedTriangles& to, const IndexedTriangles& more) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& [a, b, c] : more.triangles) {
    to.triangles.push_back({first + a, first + b, first + c});
  }
}

IndexedTriangles box(const Vec3<double>& lower, const Vec3<double>& upper) {
  return trianglesOf(tessellation::box(lower, upper));
}

double volumeOf(const IndexedTriangles& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    sum += dot(surface.positions[a], cross(surface.positions[b], surface.positions[c])) / 6;
  }
  return sum;
}

double areaOf(const IndexedTriangles& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& p = surface.positions;
    sum += length(cross(p[b] - p[a], p[c] - p[a])) / 2;
  }
  return sum;
}

TEST(CellPiecesTest, SurfacesInGeneralPositionKeepVolumeAndArea) {
  for (const auto& surface :
       {placed(trianglesOf(tessellation::icosphere(0.37, 3)), {.5, .49, .51}),
        placed(trianglesOf(tessellation::torus(0.3, 0.1, 40, 20)), {.5, .51, .49}),
        placed(box({-.3, -.2, -.25}, {.3, .2, .25}), {.51, .5, .5})}) {
    for (const int n : {5, 16}) {
      const CutTile cut(surface, 0, 1, n);
      EXPECT_NEAR(cut.fluidVolume(), 1 - volumeOf(surface), 1e-14);
      EXPECT_NEAR(cut.wallArea(), areaOf(surface), 1e-12);
      EXPECT_LT(cut.worstClosure(), 4e-15);
    }
  }
}

TEST(CellPiecesTest, WallsInPlanesOfTheGridBelongToTheCellsOfTheFluid) {
  const CutTile cut(box({.25, .25, .25}, {.5, .75, .625}), 0, 1, 8);
  EXPECT_EQ(cut.fluidVolume(), 1 - 0.25 * 0.5 * 0.375);
  EXPECT_EQ(cut.wallArea(), 2 * (0.25 * 0.5 + 0.25 * 0.375 + 0.5 * 0.375));
  EXPECT_EQ(cut.worstClosure(), 0);
  std::size_t walls = 0;
  for (const auto& piece : cut.result.pieces) {
    EXPECT_EQ(piece.volume, 0x1p-9);
    walls += piece.area > 0 ? 1 : 0;  // others touch an edge or a corner of the box
  }
  EXPECT_EQ(walls, 2U * (2 * 4 + 2 * 3 + 4 * 3));
}

TEST(CellPiecesTest, APlateParsACellHoweverThin) {
  for (const double thickness : {0.01, 1e-6, 1e-12}) {
    const auto surface = box({-.5, -.5, .4}, {1.5, 1.5, .4 + thickness});
    const CutTile cut(surface, 0, 1, 1);
    ASSERT_EQ(cut.result.pieces.size(), 2U);
    const auto& [below, above] = std::pair(cut.result.pieces[0], cut.result.pieces[1]);
    EXPECT_NEAR(std::min(below.volume, above.volume), 0.4, 1e-15);
    EXPECT_NEAR(below.volume + above.volume, 1 - thickness, 1e-15);
    EXPECT_NEAR(std::min(below.centroid.z, above.centroid.z), 0.2, 1e-15);
    EXPECT_LT(cut.worstClosure(), 1e-15);
    EXPECT_EQ(cut.result.arcs.size(), 2U + 4 * 2);  // two parts of each face at the side
  }
}

TEST(CellPiecesTest, ABubbleAndTheFluidAroundItAreTwoPieces) {
  // A cavity within a ball within one cell.
  auto surface = trianglesOf(tessellation::icosphere(0.4, 2));
  auto cavity = trianglesOf(tessellation::icosphere(0.2, 2));
  const double inside = volumeOf(cavity);
  const double outside = 1 - volumeOf(surface);
  for (auto& [a, b, c] : cavity.triangles) std::swap(b, c);
  add(surface, cavity);
  for (auto& p : surface.positions) p += {.5, .5, .5};
  const CutTile cut(surface, 0, 1, 1);
  ASSERT_EQ(cut.result.pieces.size(), 2U);
  EXPECT_NEAR(std::min(cut.result.pieces[0].volume, cut.result.pieces[1].volume), inside, 1e-15);
  EXPECT_NEAR(std::max(cut.result.pieces[0].volume, cut.result.pieces[1].volume), outside, 1e-15);
  EXPECT_EQ(cut.result.arcs.size(), 6U);  // of the piece around the ball
}

/// Three wedges of body that share an edge, around which the fluid is in three others.
TEST(CellPiecesTest, WedgesAroundAnEdgeAreApart) {
  constexpr double kPi = 3.14159265358979323846;
  for (const double turn : {0.0, 0.3, 1.1, 2.0}) {
    IndexedTriangles surface{.positions = {{0.41, 0.52, -1}, {0.41, 0.52, 2}}, .triangles = {}};
    for (int wedge = 0; wedge < 3; ++wedge) {
      const auto first = static_cast<std::uint32_t>(surface.positions.size());
      for (const double z : {-1.0, 2.0}) {
        for (const double more : {0.0, 0.7}) {
          const double angle = turn + wedge * 2 * kPi / 3 + more;
          surface.positions.push_back({0.41 + 5 * std::cos(angle), 0.52 + 5 * std::sin(angle), z});
        }
      }
      const auto [a, b, c, d] = std::array{first, first + 1, first + 2, first + 3};
      for (const auto& t : std::array<std::array<std::uint32_t, 3>, 8>{{{0, 1, d},
                                                                        {0, d, b},
                                                                        {0, b, a},
                                                                        {1, c, d},
                                                                        {0, a, c},
                                                                        {0, c, 1},
                                                                        {a, b, d},
                                                                        {a, d, c}}}) {
        surface.triangles.push_back(t);
      }
    }
    const CutTile cut(surface, 0, 1, 1);
    EXPECT_EQ(cut.result.pieces.size(), 3U) << turn;
    EXPECT_LT(cut.worstClosure(), 4e-15);
  }
}

/// Tilted, as thick as rounding: its sheets cross the edges of the grid in places that may be equal
/// or in the wrong order.
TEST(CellPiecesTest, APlateAsThickAsRoundingPartsCells) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(0, 1);
  for (int n = 0; n < scaled(200); ++n) {
    auto surface = box({-3, -3, 0}, {3, 3, std::ldexp(1.0, -50 - n % 4)});
    const double x = 0.4 * number(random);
    const double y = 0.4 * number(random);
    const double z = 0.5 - 0.5 * (x + y) - 0.01 * number(random);
    for (auto& p : surface.positions) p.z += x * p.x + y * p.y + z;
    const CutTile cut(surface, 0, 1, 1);
    EXPECT_EQ(cut.result.pieces.size(), 2U) << n;
    EXPECT_NEAR(cut.fluidVolume(), 1, 1e-14);
    EXPECT_LT(cut.worstClosure(), 1e-14);
  }
}

TEST(CellPiecesTest, RodsPierceFacesWithoutTouchingEdges) {
  const CutTile cut(box({-.5, .4, .4}, {1.5, .6, .6}), 0, 1, 1);
  ASSERT_EQ(cut.result.pieces.size(), 1U);
  EXPECT_NEAR(cut.result.pieces[0].volume, 0.96, 1e-15);
  EXPECT_NEAR(length(cut.result.pieces[0].centroid - Vec3<double>{.5, .5, .5}), 0, 1e-15);
  EXPECT_LT(cut.worstClosure(), 1e-15);
}

/// A cell in boxes between all planes: those of the grid and those of a voxel solid.
class CellBoxes {
 public:
  CellBoxes(const VoxelSolid& solid, const CutTile& cut, const TilePlace& cell) : solid_(solid) {
    for (std::size_t a = 0; a < 3; ++a) {
      const double lower = cut.positions[static_cast<std::size_t>(cell[a])];
      const double upper = cut.positions[static_cast<std::size_t>(cell[a]) + 1];
      first_[a] = static_cast<int>(std::floor(lower / solid.width()));
      planes_[a] = {lower};
      for (int i = first_[a] + 1; i * solid.width() < upper; ++i) {
        planes_[a].push_back(i * solid.width());
      }
      size_[a] = static_cast<int>(planes_[a].size());
      planes_[a].push_back(upper);
    }
  }

  /// The sizes of the parts that the solid leaves.
  std::vector<double> flooded() {
    std::vector<double> result;
    for (int x = 0; x < size_[0]; ++x) {
      for (int y = 0; y < size_[1]; ++y) {
        for (int z = 0; z < size_[2]; ++z) {
          if (isNew({x, y, z})) result.push_back(floodedFrom({x, y, z}));
        }
      }
    }
    return result;
  }

 private:
  using Place = VoxelSolid::Place;

  /// Whether this is a box of fluid that was not seen before.
  bool isNew(const Place& p) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (p[a] < 0 || p[a] >= size_[a]) return false;
    }
    return !solid_.has({first_[0] + p[0], first_[1] + p[1], first_[2] + p[2]}) &&
           seen_.insert(p).second;
  }
  [[nodiscard]] double volumeOf(const Place& p) const {
    double volume = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto i = static_cast<std::size_t>(p[a]);
      volume *= planes_[a][i + 1] - planes_[a][i];
    }
    return volume;
  }
  double floodedFrom(const Place& start) {
    double volume = 0;
    std::vector<Place> pending{start};
    while (!pending.empty()) {
      const auto p = pending.back();
      pending.pop_back();
      volume += volumeOf(p);
      for (std::size_t a = 0; a < 3; ++a) {
        for (const int step : {-1, 1}) {
          auto next = p;
          next[a] += step;
          if (isNew(next)) pending.push_back(next);
        }
      }
    }
    return volume;
  }

  const VoxelSolid& solid_;
  std::array<std::vector<double>, 3> planes_;
  std::array<int, 3> first_{};
  std::array<int, 3> size_{};
  std::set<Place> seen_;
};

/// `isTight`: voxels do not touch along edges or in vertices only, and neither does what is around
/// them.
VoxelSolid randomSolid(std::mt19937& random, int kind, bool isTight) {
  VoxelSolid solid(1.0 / 16);
  const int share = 15 + static_cast<int>(random() % 70);
  for (int x = 1; x < 11; ++x) {
    for (int y = 1; y < 11; ++y) {
      for (int z = 1; z < 11; ++z) {
        const bool isIn = static_cast<int>(random() % 100) < share;
        const bool isTunnel = kind == 1 && x % 3 == 1 && y % 3 == 1;
        const bool isPlate = kind == 2 && x % 4 == 2;
        if ((isIn && !isTunnel) || isPlate) solid.add({x, y, z});
      }
    }
  }
  if (isTight) solid.close(11);
  return solid;
}

/// Compares the pieces of all cells with those of a flood; counts the cells with several pieces.
void expectFlooded(const VoxelSolid& solid, double lower, double upper, int n,
                   std::size_t& several) {
  const auto surface = solid.surface();
  const CutTile cut(surface, lower, upper, n);
  const auto found = cut.volumes();
  for (std::uint32_t cell = 0; cell < found.size(); ++cell) {
    auto volumes = found[cell];
    auto expected = CellBoxes(solid, cut, cut.tile.numbers().placeOfCell(cell)).flooded();
    std::erase_if(expected,
                  [](double volume) { return volume < 1e-20; });  // planes as good as equal
    std::ranges::sort(volumes);
    std::ranges::sort(expected);
    ASSERT_EQ(volumes.size(), expected.size()) << "cell " << cell;
    for (std::size_t i = 0; i < volumes.size(); ++i) EXPECT_NEAR(volumes[i], expected[i], 1e-15);
    several += volumes.size() > 1 ? 1 : 0;
  }
  EXPECT_LT(cut.worstClosure(), 4e-15);
  EXPECT_NEAR(cut.wallArea(), areaOf(surface), 1e-12);
}

TEST(CellPiecesTest, PiecesOfVoxelSolidsAreThoseOfAFlood) {
  for (const bool isTight : {true, false}) {
    std::mt19937 random(5);
    std::size_t several = 0;
    for (int n = 0; n < scaled(24) && !HasFailure(); ++n) {
      const double lower = -0.0317 - 0.0001 * n;
      expectFlooded(randomSolid(random, n % 3, isTight), lower, lower + 0.85, 3 + n % 3, several);
    }
    EXPECT_GT(several, 200U);
  }
}

TEST(CellPiecesTest, PiecesOfVoxelSolidsInPlanesOfTheGridAreThoseOfAFlood) {
  std::mt19937 random(6);
  std::size_t several = 0;
  for (int n = 0; n < scaled(48) && !HasFailure(); ++n) {
    expectFlooded(randomSolid(random, n % 3, true), 0, 0.75, n % 2 == 0 ? 3 : 4, several);
  }
  EXPECT_GT(several, 200U);
}

/// All ways in which eight cells around a node may be body, with walls in the planes between them.
TEST(CellPiecesTest, CellsThatAreBodyAsAWholeLeaveTheOthersWhole) {
  for (int mask = 1; mask < 256; ++mask) {
    VoxelSolid solid(1);
    for (int k = 0; k < 8; ++k) {
      if ((mask >> k & 1) != 0) solid.add({1 + (k & 1), 1 + (k >> 1 & 1), 1 + (k >> 2)});
    }
    const CutTile cut(solid.surface(), 1, 3, 2);
    const auto found = cut.volumes();
    for (std::uint32_t cell = 0; cell < 8; ++cell) {
      const auto place = cut.tile.numbers().placeOfCell(cell);
      const bool isBody = (mask >> (place[0] + 2 * place[1] + 4 * place[2]) & 1) != 0;
      EXPECT_EQ(found[cell], isBody ? std::vector<double>{} : std::vector<double>{1}) << mask;
    }
    EXPECT_EQ(cut.worstClosure(), 0) << mask;
  }
}

}  // namespace
}  // namespace cutwater::test
