#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

PolygonSoup ballOf(double radius) {
  return tessellation::icosphere(radius, 2);
}

double volumeOf(const PolygonSoup& soup) {
  return measure(soup).volume;
}

TEST(Orientation, TurnedFacesAreTurnedBack) {
  const auto torus = tessellation::torus(2, 0.5, 24, 12);
  auto soup = torus;
  for (const std::size_t i : {3U, 77U, 78U, 200U}) soup = flipped(soup, i);
  const auto found = orientFaces(soup);
  EXPECT_EQ(found.faces.places.count, 4U);
  EXPECT_LT(length(found.faces.places.examples[1] - middleOf(torus, 77)), 1e-12);
  EXPECT_FALSE(found.shells);
  EXPECT_EQ(volumeOf(soup), volumeOf(torus));
  EXPECT_TRUE(reportOf(soup).isClean());

  auto turned = insideOut(flipped(torus, 5));
  const auto all = orientFaces(turned);
  EXPECT_EQ(all.faces.places.count, 1U);
  EXPECT_EQ(all.shells.places.count, 1U);
  EXPECT_TRUE(reportOf(turned).isClean());
  EXPECT_FALSE(orientFaces(turned).shells);
}

TEST(Orientation, PointsOfNoFaceMayBeAnywhere) {
  for (const double size : {1.0, 1e-200}) {
    auto soup = withPoints(insideOut(flipped(cube(), 2)), [&](const auto& p) { return size * p; });
    soup.points.emplace_back(0, 1e150, 0);
    const auto found = orientFaces(soup);
    EXPECT_EQ(found.faces.places.count, 1U);
    EXPECT_EQ(found.shells.places.count, 1U);
    EXPECT_EQ(soup.points.back().y, 1e150);
  }
}

TEST(Orientation, ShellsWithinShellsByPolicy) {
  const double big = volumeOf(ballOf(3));
  const double middle = volumeOf(ballOf(2));
  const double small = volumeOf(ballOf(1));
  // Every combination of three balls in one another, each outward or inward.
  for (int ways = 0; ways < 8; ++ways) {
    PolygonSoup soup;
    soup.patchNames = {"balls"};
    for (int i = 0; i < 3; ++i) {
      const auto ball = ballOf(3 - i);
      soup = together(soup, (ways >> i & 1) != 0 ? insideOut(ball) : ball);
    }
    auto cavities = soup;
    orientFaces(cavities, NestedShells::Cavities);
    EXPECT_NEAR(volumeOf(cavities), big - middle + small, 1e-12) << ways;
    EXPECT_EQ(orientFaces(cavities, NestedShells::Cavities).shells.places.count, 0U);
    auto solids = soup;
    const auto turned = orientFaces(solids, NestedShells::Solids).shells.places.count;
    EXPECT_EQ(turned, static_cast<std::size_t>((ways & 1) + (ways >> 1 & 1) + (ways >> 2 & 1)));
    EXPECT_NEAR(volumeOf(solids), big + middle + small, 1e-12) << ways;
    auto asTheyAre = soup;
    orientFaces(asTheyAre);
    // As they stood to the outermost, which faces outward.
    const double s = (ways & 1) != 0 ? -1 : 1;
    EXPECT_NEAR(
        volumeOf(asTheyAre),
        big + s * ((ways & 2) != 0 ? -middle : middle) + s * ((ways & 4) != 0 ? -small : small),
        1e-12)
        << ways;
  }
}

TEST(Orientation, AMoebiusStripStaysAsItIsTheNextTime) {
  for (const std::uint32_t n : {5U, 48U, 49U}) {
    auto soup = twistedBand(n, 0.3, 1);
    EXPECT_EQ(orientFaces(soup).unorientable, 1U);
    const auto once = soup;
    const auto again = orientFaces(soup);
    EXPECT_EQ(again.unorientable, 1U);
    EXPECT_FALSE(again.faces);
    EXPECT_TRUE(sameSoup(soup, once));
  }
}

TEST(Orientation, AnySize) {
  for (const double scale : {1e-200, 1e200}) {
    auto soup = withPoints(insideOut(cube()), [&](const auto& p) { return scale * p; });
    EXPECT_EQ(orientFaces(soup).shells.places.count, 1U);
    EXPECT_TRUE(std::ranges::equal(soup.polygon(0), std::array{2U, 0U, 4U, 6U}));
    EXPECT_EQ(orientFaces(soup).shells.places.count, 0U);
  }
}

}  // namespace
}  // namespace cutwater::test
