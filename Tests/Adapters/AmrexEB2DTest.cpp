#include <Cutwater/Adapters/AmrexEB.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <numbers>

#include "EBRules.hpp"

namespace cutwater::test {
namespace {

using amrex::Box;
using amrex::IntVect;

amrex::Geometry squareOf(int n) {
  return {Box(IntVect(0), IntVect(n - 1)), {0, 0}, {1, 1}};
}

/// A plane through a ball, above its middle: a disc.
constexpr double kZ = 0.6;
const Sphere<double> kBall({0.5012, 0.4987, 0.5031}, 0.3);

TEST(AmrexEB2DTest, EveryLevelKeepsTheRules) {
  auto geometry = squareOf(64);
  const auto& space = buildEB(SolidCutter(Solid<double>(kBall)), geometry, {.z = kZ});
  double lost = 0;
  for (;; geometry = amrex::coarsen(geometry, 2)) {
    const auto& level = space.getLevel(geometry);
    const EBRules rules(level);
    EXPECT_EQ(rules.broken(), 0U);
    EXPECT_LT(rules.worstClosure(), 5e-12);
    EXPECT_GT(rules.cut(), 3U);
    for (const auto& piece : space.cells(geometry).lost()) lost += piece.volume;
    auto fields = const_cast<amrex::EB2::Level&>(level).fields();  // NOLINT
    const double n = geometry.Domain().length(0);
    double missing = lost * n * n;
    for (amrex::MFIter grid(fields.volfrac); grid.isValid(); ++grid) {
      const auto box = grid.validbox() & geometry.Domain();
      const auto volume = fields.volfrac.const_array(grid);
      for (int j = box.smallEnd(1); j <= box.bigEnd(1); ++j) {
        for (int i = box.smallEnd(0); i <= box.bigEnd(0); ++i) missing -= 1 - volume(i, j, 0);
      }
    }
    for (const auto& box : fields.covered.boxes()) missing -= box.length(0) * box.length(1);
    const double disc = std::numbers::pi * (0.09 - (kZ - 0.5031) * (kZ - 0.5031));
    EXPECT_NEAR(missing / n / n, -disc, 1e-9);
    if (geometry.Domain() == space.coarsestDomain()) break;
  }
  amrex::EB2::IndexSpace::clear();
}

// A rod along x: its ends lie beyond, and its sides are as in the domain.
TEST(AmrexEB2DTest, BodiesGoOnBeyondTheDomain) {
  const auto geometry = squareOf(16);
  const Solid<double> rod = Capsule<double>({-9, 0.52, 0}, {9, 0.52, 0}, 0.2);
  const auto& space = buildEB(SolidCutter(rod), geometry, {.beyond = 4, .boxes = 4});
  auto fields = const_cast<amrex::EB2::Level&>(space.getLevel(geometry)).fields();  // NOLINT
  int beyond = 0;
  for (amrex::MFIter grid(fields.volfrac); grid.isValid(); ++grid) {
    const auto box = grid.validbox();
    for (int j = box.smallEnd(1); j <= box.bigEnd(1); ++j) {
      for (int i = box.smallEnd(0); i <= box.bigEnd(0); ++i) {
        const double from = j / 16.0;
        const double body = std::max(0.0, std::min(from + 1 / 16.0, 0.72) - std::max(from, 0.32));
        EXPECT_NEAR(fields.volfrac.const_array(grid)(i, j, 0), 1 - 16 * body, 1e-12);
        EXPECT_NEAR(fields.areafrac[0].const_array(grid)(i, j, 0), 1 - 16 * body, 1e-12);
        const bool isCut = body > 0 && body < 1 / 16.0 - 1e-12;
        const double sign = j < 8 ? 1 : -1;
        const double edge = fields.edgecent[1].const_array(grid)(i, j, 0);
        if (isCut) {
          EXPECT_NEAR(fields.bndrynorm.const_array(grid)(i, j, 0, 1), sign, 1e-12);
          EXPECT_NEAR(edge, -sign * 8 * body, 1e-9);
        } else {
          EXPECT_EQ(edge, body > 0 ? -1 : 1);
        }
        if (isCut && (i < 0 || i > 15)) ++beyond;
      }
    }
  }
  EXPECT_EQ(beyond, 2 * 2 * 4);
  amrex::EB2::IndexSpace::clear();
}

TEST(AmrexEB2DTest, APeriodIsRefused) {
  const amrex::Geometry geometry(Box(IntVect(0), IntVect(7)), {0, 0}, {1, 1}, {1, 0});
  const SolidCutter cutter(Solid<double>(kBall), FluidSide::Outside, {.period = {1, 0, 0}});
  EXPECT_THROW(static_cast<void>(buildEB(cutter, geometry)), Error);
  EXPECT_THROW(static_cast<void>(buildEB(SolidCutter(Solid<double>(kBall)), geometry)), Error);
}

}  // namespace
}  // namespace cutwater::test
