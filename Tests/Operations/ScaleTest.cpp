#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ScaleTest : public ::testing::Test {
 protected:
  Sphere<T> ball_{{1, 0, 0}, 2};
  CappedCone<T> cone_{{0, T(0.25), 0}, {0, T(0.25), 1}, 1, T(0.5)};
};
TYPED_TEST_SUITE(ScaleTest, Precisions);

TYPED_TEST(ScaleTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto large = scaled(this->ball_, 3);  // centre (3, 0, 0), radius 6
  EXPECT_EQ(large.signedDistance({3, 0, 0}), T(-6));
  EXPECT_EQ(large.signedDistance({3, 0, 9}), T(3));
  EXPECT_EQ(large.closestPoint({12, 0, 0}).point, (Vec3<T>{9, 0, 0}));
  EXPECT_EQ(large.closestPoint({12, 0, 0}).distance, T(3));
  const auto mirrored = scaled(this->ball_, -2);  // centre (-2, 0, 0), radius 4
  EXPECT_EQ(mirrored.signedDistance({-2, 0, 0}), T(-4));
  EXPECT_EQ(mirrored.signedDistance({4, 0, 0}), T(2));
  EXPECT_EQ(mirrored.gradient({4, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(mirrored.closestPoint({4, 0, 0}).normal, (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(mirrored.classify({{-3, -1, -1}, {-1, 1, 1}}), BoxClass::Inside);
  EXPECT_NEAR(mirrored.boundingBox().lower.x, T(-6), tolerance<T>(10, 64));
  mirrored.crossings({{9, 0, 0}, {-2, 0, 0}}, [](const Crossing<T>& c) {
    EXPECT_NEAR(c.point.x, T(2), tolerance<T>(10));
    EXPECT_NEAR(c.normal.x, T(1), tolerance<T>(1));
    EXPECT_TRUE(c.entering);
    return true;
  });
}

TYPED_TEST(ScaleTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(scaled(this->cone_, T(1.7)), 3);
  expectGuarantee(scaled(this->cone_, T(-0.3)), 0.75, {.inside = [](const Vec3<double>& p) {
                    const Vec3<double> q = p / static_cast<double>(T(-0.3));
                    return q.z > 0 && q.z < 1 && std::hypot(q.x, q.y - 0.25) < 1 - 0.5 * q.z;
                  }});
  expectGuarantee(scaled(this->cone_ | this->ball_, 1000), 4000);
}

TYPED_TEST(ScaleTest, RefusesImpossibleFactors) {
  using T = TypeParam;
  for (const T bad : {T(0), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN(),
                      std::numeric_limits<T>::denorm_min()}) {
    EXPECT_THROW(static_cast<void>(scaled(this->ball_, bad)), Error);
  }
}

}  // namespace
}  // namespace cutwater::test
