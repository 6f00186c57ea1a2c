// Cleaning, caps, mirror images and extensions of surfaces from real files.

#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

PolygonSoup read(const std::string& file) {
  return readSurface(CUTWATER_OPENFOAM_EXAMPLES "/" + file).soup;
}

MeshReport reportOf(const PolygonSoup& soup) {
  return check(DcelMesh<double>(soup));
}

void expectCleanTwiceAsOnce(const PolygonSoup& cleaned, const CleanOptions& options) {
  auto again = cleaned;
  const auto report = clean(again, options);
  EXPECT_TRUE(report.changedNothing()) << report.text();
  EXPECT_EQ(again.corners, cleaned.corners);
}

TEST(Cleaning, BuildingsLoseTheirNeedlesAndStayClosed) {
  auto soup =
      read("incompressible/simpleFoam/windAroundBuildings/constant/triSurface/buildings.obj.gz");
  const auto before = reportOf(soup);
  ASSERT_EQ(before.zeroAreaFaces.count, 228U);
  const auto report = clean(soup);
  EXPECT_EQ(report.count(CleanKind::DegenerateFaces), 228U);
  const auto after = reportOf(soup);
  EXPECT_TRUE(after.isClosed()) << after.summary();
  EXPECT_TRUE(after.isOriented());
  EXPECT_FALSE(after.zeroAreaFaces || after.repeatedCornerFaces);
  EXPECT_NEAR(after.area, before.area, 1e-9 * before.area);
  EXPECT_NEAR(after.volume, before.volume, 1e-9 * before.volume);
  expectCleanTwiceAsOnce(soup, {});
}

TEST(Cleaning, PanelsOfAMotorBikeStayUnlessToldOtherwise) {
  const auto bike = read("resources/geometry/motorBike.obj.gz");
  auto soup = bike;
  EXPECT_EQ(clean(soup).count(CleanKind::DuplicateFaces), 0U);
  EXPECT_EQ(soup.polygonCount(), bike.polygonCount());
  const CleanOptions options{.opposite = OppositeFaces::Cancel};
  EXPECT_EQ(clean(soup, options).count(CleanKind::OppositeFaces), 2 * 67326U);
  EXPECT_TRUE(reportOf(soup).isManifold());
  EXPECT_EQ(reportOf(soup).boundaryEdges.count, reportOf(bike).boundaryEdges.count);
  expectCleanTwiceAsOnce(soup, options);
}

TEST(Cleaning, ATurbinesShaftIsWelded) {
  auto soup = read(
      "mesh/foamyHexMesh/mixerVessel/constant/triSurface/rawSurfaces/"
      "rotating_unscaled.stl.gz");
  EXPECT_EQ(reportOf(soup).boundaryEdges.count, 114U);
  const CleanOptions options{.weldWithin = 1e-6 * soup.boundingBox().diagonal()};
  clean(soup, options);
  EXPECT_TRUE(reportOf(soup).isClean()) << reportOf(soup).summary();
  expectCleanTwiceAsOnce(soup, options);
}

TEST(Cleaning, TwoEndsOfAStemAreCapped) {
  auto soup =
      read("incompressible/pimpleFoam/RAS/propeller/constant/triSurface/propellerStem1.obj.gz");
  clean(soup, {.weldWithin = 1e-8});
  const auto box = soup.boundingBox();
  for (const auto& corner : {box.lower, box.upper}) {
    const auto report = capOnPlane(soup, {corner, {0, 1, 0}}, {.tolerance = 1e-7});
    EXPECT_EQ(report.closed.count, 1U);
    EXPECT_EQ(report.rimEdges, 136U);
  }
  EXPECT_TRUE(reportOf(soup).isClosedOriented()) << reportOf(soup).summary();
}

TEST(Cleaning, AHullIsClosedAtItsDeck) {
  auto soup = read("resources/geometry/wigley.stl.gz");
  clean(soup, {.opposite = OppositeFaces::Cancel});
  EXPECT_FALSE(reportOf(soup).isClosed());
  const auto report = capOnPlane(soup, {{0, 0, 0.04}, {0, 0, 1}}, {.tolerance = 1e-7});
  EXPECT_EQ(report.closed.count, 1U);
  EXPECT_TRUE(reportOf(soup).isClean()) << reportOf(soup).summary();
  // The parabolic hull below the waterline, length 1, beam 0.1, draught 0.0625: 4/9 of its box;
  // above it the sides are straight, over 2/3 of the deck's box.
  const double below = 4.0 / 9 * 0.1 * 0.0625;
  const double above = 2.0 / 3 * 0.1 * 0.04;
  EXPECT_NEAR(report.after.volume, below + above, 0.01 * (below + above));
}

TEST(Cleaning, TheGroundBelowARealTerrain) {
  auto soup = read("incompressible/simpleFoam/turbineSiting/constant/triSurface/terrain.stl.gz");
  clean(soup);
  const auto box = soup.boundingBox();
  const auto report = extendTo(soup, 2, box.lower.z - 100);
  EXPECT_EQ(report.closed.count, 1U);
  EXPECT_TRUE(reportOf(soup).isClean()) << reportOf(soup).summary();
  EXPECT_GT(report.after.volume, 100 * box.size().x * box.size().y);
  EXPECT_LT(report.after.volume, (100 + box.size().z) * box.size().x * box.size().y);
}

}  // namespace
}  // namespace cutwater::test
