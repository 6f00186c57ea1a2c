#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

TEST(UnusedPoints, AreRemovedAndTheOthersKeepTheirOrder) {
  auto soup = tetrahedron();
  soup.points.insert(soup.points.begin(), {9, 9, 9});
  soup.points.insert(soup.points.begin() + 3, {8, 8, 8});
  soup.points.push_back({7, 7, 7});
  for (auto& corner : soup.corners) corner += corner < 2 ? 1 : 2;
  const auto found = removeUnusedPoints(soup);
  EXPECT_EQ(found.places.count, 3U);
  EXPECT_EQ(found.places.examples, (std::vector<Vec3<double>>{{9, 9, 9}, {8, 8, 8}, {7, 7, 7}}));
  EXPECT_TRUE(sameSoup(soup, tetrahedron()));
  EXPECT_FALSE(removeUnusedPoints(soup));
}

TEST(UnusedPoints, ASoupWithoutFacesHasNoOthers) {
  PolygonSoup soup;
  soup.points.resize(100);
  const auto found = removeUnusedPoints(soup);
  EXPECT_EQ(found.places.count, 100U);
  EXPECT_EQ(found.places.examples.size(), 8U);
  EXPECT_TRUE(soup.points.empty());
}

}  // namespace
}  // namespace cutwater::test
