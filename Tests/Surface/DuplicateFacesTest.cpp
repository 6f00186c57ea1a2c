#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

/// So many copies of a triangle each way, in turns, among the faces of a tetrahedron.
PolygonSoup copies(int forward, int backward) {
  auto soup = tetrahedron();
  const std::uint32_t first = 4;
  for (const Vec3<double> p : {Vec3<double>{5, 0, 0}, {6, 0, 0}, {5, 1, 0}})
    soup.points.push_back(p);
  const std::array<std::array<std::uint32_t, 3>, 3> turns{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};
  for (int i = 0; i < std::max(forward, backward); ++i) {
    const auto& [a, b, c] = turns[static_cast<std::size_t>(i) % 3];
    if (i < forward) soup.addPolygon(std::array{first + a, first + b, first + c});
    if (i < backward) soup.addPolygon(std::array{first + c, first + b, first + a});
  }
  return soup;
}

TEST(DuplicateFaces, TheFirstOfEachOrientationStays) {
  auto soup = copies(3, 2);
  const auto found = removeDuplicateFaces(soup);
  EXPECT_EQ(found.places.count, 3U);
  EXPECT_EQ(found.places.examples[0], (Vec3<double>{16.0 / 3, 1.0 / 3, 0}));
  EXPECT_EQ(found.largest, std::sqrt(2.0));
  EXPECT_TRUE(sameSoup(soup, copies(1, 1)));
  EXPECT_FALSE(removeDuplicateFaces(soup));
}

TEST(DuplicateFaces, PairsCancelAndTheRestIsOfOneKind) {
  for (int forward = 0; forward < 4; ++forward) {
    for (int backward = 0; backward < 4; ++backward) {
      auto soup = copies(forward, backward);
      const auto before = imbalances(soup);
      const auto cancelled = cancelOppositeFaces(soup);
      EXPECT_EQ(cancelled.places.count, 2U * static_cast<unsigned>(std::min(forward, backward)));
      EXPECT_EQ(imbalances(soup), before);
      removeDuplicateFaces(soup);
      const bool some = forward != backward;
      EXPECT_EQ(soup.polygonCount(), some ? 5U : 4U) << forward << " " << backward;
      if (!some) continue;
      const auto left = soup.polygon(4);
      const bool isForward = (left[0] - 4 + 1) % 3 == left[1] - 4;
      EXPECT_EQ(isForward, forward > backward) << forward << " " << backward;
    }
  }
}

TEST(DuplicateFaces, ADuplicateMayBeTurned) {
  const auto sphere = tessellation::icosphere(1, 2);
  auto soup = sphere;
  // By itself, beside another, and one more that is there three times.
  for (const std::size_t i : {5U, 40U, 41U, 42U, 43U, 100U, 100U}) {
    soup.addPolygon(sphere.polygon(i));
    soup = flipped(soup, soup.polygonCount() - 1);
  }
  EXPECT_EQ(removeDuplicateFaces(soup).places.count, 7U);
  EXPECT_TRUE(sameSoup(soup, sphere));
  EXPECT_FALSE(removeDuplicateFaces(soup));
}

TEST(DuplicateFaces, OfPolygonsTheWholeCycleCounts) {
  auto soup = cube();
  const std::array turned{6U, 2U, 0U, 4U};   // the first face from another corner
  const std::array crossed{0U, 6U, 4U, 2U};  // the same corners in another order
  soup.addPolygon(turned);
  soup.addPolygon(crossed);
  EXPECT_EQ(removeDuplicateFaces(soup).places.count, 1U);
  EXPECT_EQ(soup.polygonCount(), 7U);
  EXPECT_TRUE(std::ranges::equal(soup.polygon(6), crossed));
  EXPECT_FALSE(cancelOppositeFaces(soup));
}

TEST(DuplicateFaces, RepeatedCornersArePassedOver) {
  auto soup = makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 1}, {0, 1, 1}, {1, 0, 1}});
  EXPECT_FALSE(removeDuplicateFaces(soup));
  EXPECT_FALSE(cancelOppositeFaces(soup));
}

TEST(DuplicateFaces, AMeshTwiceIsAMeshOnce) {
  const auto sphere = tessellation::icosphere(1, 2);
  auto soup = weldedTogether(sphere, sphere);
  EXPECT_EQ(removeDuplicateFaces(soup).places.count, sphere.polygonCount());
  EXPECT_TRUE(sameSoup(soup, sphere));
  auto nothing = weldedTogether(sphere, insideOut(sphere));
  EXPECT_EQ(cancelOppositeFaces(nothing).places.count, 2 * sphere.polygonCount());
  EXPECT_EQ(nothing.polygonCount(), 0U);
}

}  // namespace
}  // namespace cutwater::test
