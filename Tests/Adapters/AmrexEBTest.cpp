#include <Cutwater/Adapters/AmrexEB.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "EBRules.hpp"
#include "Support/Shells.hpp"

namespace cutwater::test {
namespace {

using Real = amrex::Real;
using amrex::Box;
using amrex::IntVect;

constexpr double kRounding = std::is_same_v<Real, float> ? 1e-6 : 5e-12;

/// A cube of n cells a side.
amrex::Geometry cubeOf(int n, const amrex::RealArray& lower = {0, 0, 0},
                       const amrex::RealArray& upper = {1, 1, 1},
                       const amrex::Array<int, 3>& periodic = {}) {
  return {Box(IntVect(0), IntVect(n - 1)), lower, upper, periodic};
}

/// Calls visit(geometry) for the levels of an index space, from the finest.
template <typename Visit>
void forLevels(const AmrexIndexSpace& space, amrex::Geometry geometry, const Visit& visit) {
  for (;; geometry = amrex::coarsen(geometry, 2)) {
    visit(geometry);
    if (geometry.Domain() == space.coarsestDomain()) return;
  }
}

/// Of a level's valid cells, in cells.
double fluidOf(const amrex::EB2::Level& level) {
  auto fields = const_cast<amrex::EB2::Level&>(level).fields();  // NOLINT
  double volume = 0;
  const auto domain = level.Geom().Domain();
  const auto add = [&](const Box& box, const auto& value) {
    const auto lo = amrex::lbound(box & domain);
    const auto hi = amrex::ubound(box & domain);
    for (int k = lo.z; k <= hi.z; ++k) {
      for (int j = lo.y; j <= hi.y; ++j) {
        for (int i = lo.x; i <= hi.x; ++i) volume += value(i, j, k) - 1;
      }
    }
  };
  for (amrex::MFIter grid(fields.volfrac); grid.isValid(); ++grid) {
    const auto array = fields.volfrac.const_array(grid);
    add(grid.validbox(), [&](int i, int j, int k) { return static_cast<double>(array(i, j, k)); });
  }
  for (const auto& box : fields.covered.boxes()) {
    add(box, [](int, int, int) { return 0.0; });
  }
  const double n = domain.length(0);
  return volume + n * n * n;
}

double lostOn(const AmrexIndexSpace& space, const amrex::Geometry& geometry) {
  double lost = 0;
  for (const auto& piece : space.cells(geometry).lost()) lost += piece.volume;
  return lost;
}

/// All rules on all levels, and no fluid missing but what is listed, of a unit cube.
void expectRules(const AmrexIndexSpace& space, const amrex::Geometry& finest, double fluid,
                 double tolerance) {
  forLevels(space, finest, [&](const amrex::Geometry& geometry) {
    const auto& level = space.getLevel(geometry);
    EXPECT_TRUE(level.isOK());
    EXPECT_TRUE(&space.getGeometry(geometry.Domain()) == &level.Geom());
    const EBRules rules(level);
    EXPECT_EQ(rules.broken(), 0U);
    EXPECT_LT(rules.worstClosure(), kRounding);
    EXPECT_EQ(rules.cut() > 0, space.cells(geometry).cells().cellCount > 0);
    fluid -= lostOn(space, geometry);
    EXPECT_NEAR(fluidOf(level) / std::pow(geometry.Domain().length(0), 3), fluid, tolerance);
  });
}

class AmrexEBTest : public testing::Test {
 public:
  AmrexEBTest() = default;
  AmrexEBTest(const AmrexEBTest&) = delete;
  AmrexEBTest& operator=(const AmrexEBTest&) = delete;
  ~AmrexEBTest() override { amrex::EB2::IndexSpace::clear(); }
};

TEST_F(AmrexEBTest, EveryLevelKeepsTheRules) {
  const Sphere<double> ball({0.5012, 0.4987, 0.5031}, 0.3);
  const auto geometry = cubeOf(32);
  const auto& space = buildEB(SolidCutter(Solid<double>(ball)), geometry);
  EXPECT_EQ(&amrex::EB2::IndexSpace::top(), &space);
  EXPECT_EQ(space.coarsestDomain(), Box(IntVect(0), IntVect(1)));
  const double fluid = 1 - 4 * std::numbers::pi / 3 * 0.027;
  expectRules(space, geometry, fluid, std::is_same_v<Real, float> ? 1e-6 : 1e-8);
}

TEST_F(AmrexEBTest, AMillionCellsKeepTheRules) {
  const Solid<double> torus = MeshSDF<double>(tessellation::torus(0.3, 0.11, 60, 30));
  const auto geometry = cubeOf(128, {-0.5, -0.515625, -0.53125}, {0.5, 0.484375, 0.46875});
  const auto& space = buildEB(CellCutter(torus), geometry, {.coarseLevels = 0, .boxes = 32});
  const EBRules rules(space.getLevel(geometry));
  EXPECT_GT(rules.cells(), 1'000'000U);
  EXPECT_GT(rules.cut(), 20'000U);
  EXPECT_EQ(rules.broken(), 0U);
  EXPECT_LT(rules.worstClosure(), kRounding);
}

// What no node sees: of fluid beside the plate the larger part is kept.
TEST_F(AmrexEBTest, PlatesThinnerThanACellAreThere) {
  const double h = 1.0 / 24;
  const Solid<double> plate = Cuboid<double>({12.05 * h, 0.21, 0.23}, {12.95 * h, 0.77, 0.79});
  const auto geometry = cubeOf(24);
  const auto& space = buildEB(SolidCutter(plate), geometry);
  EXPECT_FALSE(space.cells(geometry).lost().empty());
  expectRules(space, geometry, 1 - 0.9 * h * 0.56 * 0.56, 1e-6);
  const EBRules rules(space.getLevel(geometry));
  EXPECT_GT(rules.cut(), 300U);
}

// On the level with cells twice as large, fluid on one side of the plate is covered, and the cells
// beside it get a wall that no finer cell has.
TEST_F(AmrexEBTest, MultigridEndsWhereOnlyCoveringMakesWalls) {
  const double h = 1.0 / 32;
  const auto geometry = cubeOf(32);
  const auto plateFrom = [&](double x) {
    return SolidCutter(
        Solid<double>(Cuboid<double>({x * h, 0.21, 0.23}, {(x + 0.9) * h, 0.77, 0.79})));
  };
  const auto& thin = buildEB(plateFrom(16.07), geometry);
  EXPECT_GT(thin.cells(amrex::coarsen(geometry, 2)).newWallShare(), 0.3);
  EXPECT_EQ(thin.multigridLevels(geometry), 0);
  EXPECT_GT(thin.multigridLevels(amrex::coarsen(geometry, 2)), 1);
  const auto& ball =
      buildEB(SolidCutter(Solid<double>(Sphere<double>({0.5, 0.5, 0.5}, 0.3))), geometry);
  EXPECT_EQ(ball.multigridLevels(geometry), 4);
  EXPECT_THROW(static_cast<void>(ball.multigridLevels(amrex::refine(geometry, 2))), Error);
}

TEST_F(AmrexEBTest, WallsOfFewCellsAPeriodKeepTheRules) {
  const TpmsField<double> gyroid(TpmsPattern::gyroid(), 0.25);
  const Solid<double> wall = Cuboid<double>({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}) &
                             TpmsSolid<double>(gyroid, TpmsPart::Wall, 0.3);
  const auto geometry = cubeOf(16);
  const auto& space = buildEB(SolidCutter(wall), geometry);
  forLevels(space, geometry, [&](const amrex::Geometry& level) {
    const EBRules rules(space.getLevel(level));
    EXPECT_EQ(rules.broken(), 0U);
    EXPECT_LT(rules.worstClosure(), kRounding);
  });
}

// Unequal widths, and a body through two faces of the domain.
TEST_F(AmrexEBTest, BodiesGoOnBeyondTheDomain) {
  const Solid<double> rod = Capsule<double>({-9, 0.3, 0.52}, {9, 0.4, 0.57}, 0.2);
  const amrex::Geometry geometry(Box({0, 0, 0}, {15, 23, 19}), {0, 0, 0}, {1, 1, 1});
  const auto& space = buildEB(SolidCutter(rod), geometry, {.beyond = 3, .boxes = 8});
  auto fields = const_cast<amrex::EB2::Level&>(space.getLevel(geometry)).fields();  // NOLINT
  int beyond = 0;
  for (amrex::MFIter grid(fields.volfrac); grid.isValid(); ++grid) {
    const auto lo = amrex::lbound(grid.validbox());
    const auto hi = amrex::ubound(grid.validbox());
    EXPECT_GE(lo.x, -3);
    EXPECT_LE(hi.x, 18);
    const auto volume = fields.volfrac.const_array(grid);
    const auto open = fields.areafrac[0].const_array(grid);
    const auto area = fields.bndryarea.const_array(grid);
    const auto normal = fields.bndrynorm.const_array(grid);
    for (int k = lo.z; k <= hi.z; ++k) {
      for (int j = lo.y; j <= hi.y; ++j) {
        for (int i = lo.x; i < 0; ++i) {
          EXPECT_EQ(volume(i, j, k), open(0, j, k));
          EXPECT_EQ(open(i, j, k), open(0, j, k));
          if (area(i, j, k) == 0) continue;
          ++beyond;
          EXPECT_EQ(normal(i, j, k, 0), 0);
          const double y = normal(i, j, k, 1);
          const double z = normal(i, j, k, 2);
          EXPECT_NEAR(y * y + z * z, 1, 1e-5);
        }
      }
    }
  }
  EXPECT_GT(beyond, 90);
}

TEST_F(AmrexEBTest, PeriodicDomainsNeedTheirPeriod) {
  const Solid<double> ball = Sphere<double>({0.02, 0.47, 0.98}, 0.3);
  const auto geometry = cubeOf(16, {0, 0, 0}, {1, 1, 1}, {1, 0, 1});
  EXPECT_THROW(static_cast<void>(buildEB(SolidCutter(ball), geometry)), Error);
  const SolidCutter cutter(ball, FluidSide::Outside, {.period = {1, 0, 1}});
  EXPECT_THROW(static_cast<void>(buildEB(cutter, cubeOf(16))), Error);
  const auto& space = buildEB(cutter, geometry);
  expectRules(space, geometry, 1 - 4 * std::numbers::pi / 3 * 0.027, 1e-6);
}

TEST_F(AmrexEBTest, LevelsCanBeAdded) {
  const SolidCutter cutter(Solid<double>(Sphere<double>({0.5012, 0.4987, 0.5031}, 0.3)));
  const auto geometry = cubeOf(8);
  auto& space = const_cast<AmrexIndexSpace&>(  // NOLINT
      buildEB(cutter, geometry, {.coarseLevels = 1}));
  EXPECT_EQ(space.coarsestDomain().length(0), 4);
  EXPECT_THROW(static_cast<void>(space.getLevel(cubeOf(16))), Error);
  EXPECT_THROW(static_cast<void>(space.getGeometry(cubeOf(2).Domain())), Error);
  EXPECT_THROW(static_cast<void>(space.cells(cubeOf(16))), Error);
  space.addFineLevels(2);
  EXPECT_NEAR(static_cast<double>(space.cells(cubeOf(32)).cells().cellCount), 1760, 20);
  EXPECT_NEAR(static_cast<double>(space.cells(cubeOf(16)).cells().cellCount), 416, 5);
  EXPECT_EQ(EBRules(space.getLevel(cubeOf(16))).broken(), 0U);
  space.addRegularCoarseLevels(2);
  const auto& regular = space.getLevel(cubeOf(8));
  EXPECT_TRUE(regular.isAllRegular());
  EXPECT_FALSE(regular.hasEBInfo());
  EXPECT_THROW(static_cast<void>(space.cells(cubeOf(8))), Error);
  auto fields = const_cast<amrex::EB2::Level&>(regular).fields();  // NOLINT
  EXPECT_EQ(fields.maskOf, &space.getLevel(cubeOf(16)));
}

TEST_F(AmrexEBTest, AllFluidAndAllBody) {
  const Solid<double> far = Sphere<double>({5, 5, 5}, 0.3);
  const auto geometry = cubeOf(8);
  const auto& fluid = buildEB(SolidCutter(far), geometry);
  EXPECT_TRUE(fluid.getLevel(geometry).isAllRegular());
  EXPECT_TRUE(fluid.getLevel(geometry).isOK());
  EXPECT_THROW(static_cast<void>(buildEB(SolidCutter(far, FluidSide::Inside), geometry)), Error);
}

// Two boxes with a patch each.
TEST_F(AmrexEBTest, PatchesHaveTheirAreas) {
  const auto small = tessellation::box({0.1, 0.1, 0.1}, {0.4, 0.4, 0.4}, 2);
  auto soup = joined({small, tessellation::box({0.5, 0.55, 0.6}, {0.9, 0.9, 0.9}, 2)});
  std::fill(soup.patches.begin() + static_cast<std::ptrdiff_t>(small.polygonCount()),
            soup.patches.end(), 1);
  soup.patchNames = {"small", "large"};
  const auto geometry = cubeOf(16);
  const Solid<double> boxes = MeshSDF<double>(soup);
  const auto& space = buildEB(CellCutter(boxes), geometry);
  EXPECT_EQ(space.patchNames(geometry), (std::vector<std::string>{"small", "large", "covered"}));

  amrex::BoxList list(geometry.Domain());
  list.maxSize(8);
  const amrex::BoxArray grids(std::move(list));
  amrex::MultiFab areas;
  areas.define(amrex::convert(grids, IntVect(0)), amrex::DistributionMapping(grids), 3, 0);
  space.fillPatchAreas(areas, geometry);
  amrex::iMultiFab patches;
  patches.define(amrex::convert(grids, IntVect(0)), amrex::DistributionMapping(grids), 1, 0);
  space.fillPatches(patches, geometry);
  std::array<double, 3> sums{};
  for (amrex::MFIter grid(areas); grid.isValid(); ++grid) {
    const auto area = areas.const_array(grid);
    const auto patch = patches.const_array(grid);
    const auto lo = amrex::lbound(grid.validbox());
    const auto hi = amrex::ubound(grid.validbox());
    for (int k = lo.z; k <= hi.z; ++k) {
      for (int j = lo.y; j <= hi.y; ++j) {
        for (int i = lo.x; i <= hi.x; ++i) {
          for (int n = 0; n < 3; ++n) sums[static_cast<std::size_t>(n)] += area(i, j, k, n);
          const int expected = area(i, j, k, 0) > 0 ? 0 : area(i, j, k, 1) > 0 ? 1 : -1;
          EXPECT_EQ(patch(i, j, k), expected);
        }
      }
    }
  }
  EXPECT_NEAR(sums[0], 6 * 0.09, 1e-5);
  EXPECT_NEAR(sums[1], 2 * (0.4 * 0.35 + 0.35 * 0.3 + 0.3 * 0.4), 1e-5);
  EXPECT_EQ(sums[2], 0);
  amrex::MultiFab one;
  one.define(amrex::convert(grids, IntVect(0)), amrex::DistributionMapping(grids), 1, 0);
  EXPECT_THROW(space.fillPatchAreas(one, geometry), Error);
}

}  // namespace
}  // namespace cutwater::test
