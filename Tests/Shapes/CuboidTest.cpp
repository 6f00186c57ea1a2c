#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CuboidTest : public ::testing::Test {};
TYPED_TEST_SUITE(CuboidTest, Precisions);

TYPED_TEST(CuboidTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Cuboid<T> box({-1, -2, -3}, {1, 2, 3});
  EXPECT_EQ(box.signedDistance({0, 0, 0}), T(-1));
  EXPECT_EQ(box.signedDistance({0, 0, 2.5}), T(-0.5));
  EXPECT_EQ(box.signedDistance({4, 6, 3}), T(5));
  EXPECT_NEAR(box.signedDistance({3, 4, 9}), T(std::sqrt(T(44))), tolerance<T>(10));
  EXPECT_EQ(box.signedDistance({1, 0, 0}), T(0));
  EXPECT_EQ(box.signedDistance({-4, -6, 0}), T(5));
  EXPECT_EQ(box.gradient({0, 0, 2.5}), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(box.gradient({-4, -6, 0}), (Vec3<T>{T(-0.6), T(-0.8), 0}));
  EXPECT_EQ(box.gradient({0, 0, 0}), Vec3<T>{});  // two faces are equally near
  EXPECT_EQ(box.gradient({T(0.5), T(1.5), 0}), Vec3<T>{});
  EXPECT_EQ(box.gradient({1, 2, 0}), Vec3<T>{});  // on an edge
}

TYPED_TEST(CuboidTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Cuboid<T>({0, 0, 0}, {1, 0, 1})), Error);
  EXPECT_THROW((Cuboid<T>({0, 0, 0}, {1, -1, 1})), Error);
  EXPECT_THROW((Cuboid<T>({0, 0, nan}, {1, 1, 1})), Error);
  EXPECT_THROW((Cuboid<T>({0, 0, 0}, {inf, 1, 1})), Error);
}

TYPED_TEST(CuboidTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      Cuboid<T>({-1, T(-0.5), -1}, {1, T(0.75), T(0.25)}), 2, {.inside = [](const Vec3<double>& p) {
        return p.x > -1 && p.x < 1 && p.y > -0.5 && p.y < 0.75 && p.z > -1 && p.z < 0.25;
      }});
}

TYPED_TEST(CuboidTest, TellsTheFaceEdgeOrCornerThatIsNearest) {
  using T = TypeParam;
  const Cuboid<T> box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(box.closestPoint({3, 0, 0}).point, (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(box.closestPoint({3, 0, 0}).normal, (Vec3<T>{1, 0, 0}));
  EXPECT_NEAR(box.closestPoint({2, 2, 2}).point.y, T(1), tolerance<T>(2));
  EXPECT_NEAR(box.closestPoint({2, 2, 2}).normal.z, 1 / std::sqrt(T(3)), tolerance<T>(1));
  const auto fromCenter = box.closestPoint({0, 0, 0});
  EXPECT_TRUE(fromCenter.exact);
  EXPECT_NEAR(maxComponent(abs(fromCenter.point)), T(1), tolerance<T>(1));
}

TEST(CuboidRounding, StaysWithinItsBound) {
  expectRounding(Cuboid<float>({-1, -2, -3}, {1, 2, 3}), Cuboid<double>({-1, -2, -3}, {1, 2, 3}),
                 4);
  expectRounding(Cuboid<float>({99, 99, 0}, {100, 100.5f, 0.001f}),
                 Cuboid<double>({99, 99, 0}, {100, 100.5f, 0.001f}), 4);
}

}  // namespace
}  // namespace cutwater::test
