#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SphereTest : public ::testing::Test {};
TYPED_TEST_SUITE(SphereTest, Precisions);

TYPED_TEST(SphereTest, MatchesHandComputedDistances) {
  using T = TypeParam;
  const Sphere<T> sphere({1, 2, 3}, 5);
  EXPECT_EQ(sphere.signedDistance({1, 2, 3}), T(-5));
  EXPECT_EQ(sphere.signedDistance({4, 6, 3}), T(0));
  EXPECT_EQ(sphere.signedDistance({1, 2, 11}), T(3));
}

TYPED_TEST(SphereTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  EXPECT_THROW(Sphere<T>({0, 0, 0}, 0), Error);
  EXPECT_THROW(Sphere<T>({0, 0, 0}, std::numeric_limits<T>::infinity()), Error);
  EXPECT_THROW(Sphere<T>({0, std::numeric_limits<T>::quiet_NaN(), 0}, 1), Error);
}

TYPED_TEST(SphereTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Sphere<T>({T(0.25), T(-0.5), 0}, 1), 2, {.inside = [](const Vec3<double>& p) {
                    return lengthSquared(p - Vec3<double>{0.25, -0.5, 0}) < 1;
                  }});
}

TEST(SphereRounding, StaysWithinItsBound) {
  expectRounding(Sphere<float>({0, 0, 0}, 1), Sphere<double>({0, 0, 0}, 1), 4);
  expectRounding(Sphere<float>({100, 1, 0}, 0.125F), Sphere<double>({100, 1, 0}, 0.125), 4);
}

TYPED_TEST(SphereTest, TellsClosestPointsAndCrossings) {
  using T = TypeParam;
  Solid<T> sphere = Sphere<T>({0, 0, 0}, 2);
  sphere.translate({1, 0, 0});
  const auto hit = sphere.closestPoint({5, 0, 0});
  EXPECT_TRUE(hit.exact);
  EXPECT_NEAR(hit.point.x, 3, 1e-5);
  int count = 0;
  const auto walk = sphere.crossings({{-5, 0, 0}, {5, 0, 0}}, [&](const Crossing<T>& c) {
    EXPECT_NEAR(c.point.x, count == 0 ? -1 : 3, 1e-5);
    EXPECT_EQ(c.entering, count == 0);
    ++count;
    return true;
  });
  EXPECT_EQ(walk.found, 2U);
  EXPECT_EQ(walk.unresolved, 0U);
  EXPECT_EQ(sphere.classify({{2, -1, -1}, {4, 1, 1}}), BoxClass::Cut);
  EXPECT_EQ(sphere.classify({{5, -1, -1}, {6, 1, 1}}), BoxClass::Outside);
}

}  // namespace
}  // namespace cutwater::test
