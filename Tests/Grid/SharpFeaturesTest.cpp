#include <Cutwater/Grid/Detail/SharpFeatures.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Precisions.hpp"

namespace cutwater::detail {
namespace {

using cutwater::test::Precisions;
using Points = std::vector<Vec3<double>>;

constexpr auto kNowhere = [](const CellFace&) { return false; };

template <typename T>
class SharpFeaturesTest : public ::testing::Test {
 protected:
  const Box<double> cell{{0, 0, 0}, {1, 1, 1}};
  const double tiny = 20 * std::numeric_limits<T>::epsilon();

  /// A roof whose ridge lies along y at (0.4, 0.7), and what is under it.
  static Solid<T> roof() {
    return Plane<T>({T(0.4), 0, T(0.7)}, {-1, 0, 1}) & Plane<T>({T(0.4), 0, T(0.7)}, {1, 0, 1});
  }
  /// Where it cuts edges of the cell.
  static Points roofPoints() { return {{0, 0, 0.3}, {1, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.3}}; }

  void expectNear(const std::optional<Vec3<double>>& found, const Vec3<double>& expected) const {
    ASSERT_TRUE(found);
    EXPECT_LT(length(*found - expected), tiny);
  }
};
TYPED_TEST_SUITE(SharpFeaturesTest, Precisions);

TYPED_TEST(SharpFeaturesTest, FindsEdges) {
  const auto solid = this->roof();
  const SharpFeatures<TypeParam> features(solid, 30);
  // Along the ridge nothing binds it: it stays in the middle of the points.
  this->expectNear(features.pointIn(this->roofPoints(), this->cell, kNowhere), {0.4, 0.5, 0.7});
}

TYPED_TEST(SharpFeaturesTest, FindsCorners) {
  using T = TypeParam;
  const auto solid = this->roof() & Plane<T>({0, T(0.8), 0}, {0, 1, 0});
  const SharpFeatures<T> features(solid, 30);
  const Points points{{0, 0, 0.3}, {1, 0, 0.1}, {1, 0.8, 0}, {0, 0.8, 0}};
  this->expectNear(features.pointIn(points, this->cell, kNowhere), {0.4, 0.8, 0.7});
}

TYPED_TEST(SharpFeaturesTest, ThereIsNoneWhereNormalsHardlyDiffer) {
  using T = TypeParam;
  const auto solid = this->roof();
  const SharpFeatures<T> steep(solid, 100);  // the roof has 90 degrees
  EXPECT_FALSE(steep.pointIn(this->roofPoints(), this->cell, kNowhere));
  const SharpFeatures<T> none(solid, 180);
  EXPECT_FALSE(none.areWanted());
  EXPECT_FALSE(none.pointIn(this->roofPoints(), this->cell, kNowhere));
  const Sphere<T> ball({0, 0, 0}, 5);
  const SharpFeatures<T> features(ball, 30);
  const Points round{{5, 0, 0}, {4.9, 0.99, 0}, {4.9, 0, 0.99}};
  EXPECT_FALSE(features.pointIn(round, {{4, 0, 0}, {6, 1, 1}}, kNowhere));
}

TYPED_TEST(SharpFeaturesTest, ThereIsNoneOutsideOfTheCell) {
  const auto solid = this->roof();
  const SharpFeatures<TypeParam> features(solid, 30);
  EXPECT_FALSE(features.pointIn(this->roofPoints(), {{0, 0, 0}, {1, 1, 0.6}}, kNowhere));
}

TYPED_TEST(SharpFeaturesTest, TakesWhatIsInTheCellOfASlantingEdge) {
  using T = TypeParam;
  // A ridge along (1, 0, 1), which leaves the cell through its top at (0.7, 0.5, 1).
  const Vec3<T> place{T(0.7), T(0.5), 1};
  const auto solid = Plane<T>(place, {-1, 1, 1}) & Plane<T>(place, {-1, -1, 1});
  const SharpFeatures<T> features(solid, 30);
  // The nearest to the middle of these is beyond the top.
  const Points points{{0.92, 0, 0.72}, {1, 0, 0.8}, {1, 1, 0.8}, {0.92, 1, 0.72}};
  const auto found = features.pointIn(points, this->cell, kNowhere);
  ASSERT_TRUE(found);
  EXPECT_TRUE(this->cell.contains(*found));
  EXPECT_NEAR(found->x, 0.69, 1e-5);
  EXPECT_NEAR(found->y, 0.5, 1e-5);
  EXPECT_NEAR(found->z, 0.99, 1e-5);
}

TYPED_TEST(SharpFeaturesTest, AnEdgeThatPassesCloseByIsFollowedWithinTheCell) {
  using T = TypeParam;
  // A wedge between z = 1/2 and an overhang, whose tip is beyond the cell: signs do not show it.
  const auto wedge = [](T tip) {
    return Plane<T>({0, 0, T(0.5)}, {0, 0, 1}) & Plane<T>({0, tip, T(0.5)}, {0, 1, T(-0.5)});
  };
  const auto found = [&](T tip) {
    const auto solid = wedge(tip);
    const double foot = tip - 0.25;
    const Points points{{0, 0, 0.5}, {1, 0, 0.5}, {1, foot, 0}, {0, foot, 0}};
    return SharpFeatures<T>(solid, 30).pointIn(points, this->cell, kNowhere);
  };
  this->expectNear(found(T(1.02)), {0.5, 0.99, 0.5});
  EXPECT_FALSE(found(T(1.45)));  // too far
}

TYPED_TEST(SharpFeaturesTest, MayLieJustBeyondAFaceWhereThereIsNoOtherSurface) {
  const auto solid = this->roof();
  const SharpFeatures<TypeParam> features(solid, 30);
  const Box<double> flat{{0, 0, 0}, {1, 1, 0.6}};
  const auto above = [](const CellFace& face) { return face.axis == 2 && face.isUpper; };
  this->expectNear(features.pointIn(this->roofPoints(), flat, above), {0.4, 0.5, 0.7});
  // Nearer to another face of the cell beyond.
  EXPECT_FALSE(features.pointIn(this->roofPoints(), {{0, 0, 0}, {1, 1, 0.4}}, above));
  EXPECT_FALSE(features.pointIn(this->roofPoints(), {{0.3, 0, 0}, {1, 1, 0.6}}, above));
}

TYPED_TEST(SharpFeaturesTest, NoTriangleIsFoldedOver) {
  // The same points in the other order: all of the fan would look into the solid.
  auto points = this->roofPoints();
  std::reverse(points.begin(), points.end());
  const auto solid = this->roof();
  const SharpFeatures<TypeParam> features(solid, 30);
  EXPECT_FALSE(features.pointIn(points, this->cell, kNowhere));
}

TEST(JoinFeatures, TurnsEdgesBetweenFeatures) {
  // Two cells side by side, each with a fan about its feature: 4 and 5.
  const Points points{{1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 1}, {1.5, 0.5, 1}};
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 4}, {1, 0, 5}, {2, 0, 4}, {0, 3, 5}};
  const std::vector<std::size_t> fans{0, 1, 2, 3};
  joinFeatures(triangles, fans, points);
  EXPECT_EQ(triangles[0], (std::array{4U, 0U, 5U}));
  EXPECT_EQ(triangles[1], (std::array{5U, 1U, 4U}));
  EXPECT_EQ(triangles[2], (std::array{2U, 0U, 4U}));  // with no fan on the other side
  EXPECT_EQ(triangles[3], (std::array{0U, 3U, 5U}));
}

TEST(JoinFeatures, LeavesWhatWouldBeFoldedOver) {
  // One feature far to the side: the edge between the two would pass beside their triangles.
  const Points points{{1, 0, 0}, {1, 1, 0}, {}, {}, {0.5, 0.5, 0}, {1.1, 3, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 4}, {1, 0, 5}};
  const auto before = triangles;
  joinFeatures(triangles, std::vector<std::size_t>{0, 1}, points);
  EXPECT_EQ(triangles, before);
}

}  // namespace
}  // namespace cutwater::detail
