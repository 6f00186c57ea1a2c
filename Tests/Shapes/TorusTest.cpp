#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class TorusTest : public ::testing::Test {};
TYPED_TEST_SUITE(TorusTest, Precisions);

TYPED_TEST(TorusTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Torus<T> torus(3, 1);
  EXPECT_EQ(torus.signedDistance({3, 0, 0}), T(-1));
  EXPECT_EQ(torus.signedDistance({0, 0, 0}), T(2));
  EXPECT_EQ(torus.signedDistance({0, 0, 4}), T(4));
  EXPECT_EQ(torus.signedDistance({0, 7, 3}), T(4));
  EXPECT_EQ(torus.signedDistance({0, 3, 1}), T(0));
  EXPECT_EQ(torus.gradient({5, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(torus.gradient({0, 0, 2}), Vec3<T>{});  // the whole circle is equally near
  EXPECT_EQ(torus.gradient({3, 0, 0}), Vec3<T>{});
  const Torus<T> lying({1, 1, 1}, {5, 0, 0}, 3, 1);
  EXPECT_EQ(lying.signedDistance({1, 4, 1}), T(-1));
  EXPECT_EQ(lying.signedDistance({5, 1, 1}), T(4));
}

TYPED_TEST(TorusTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Torus<T>(1, 1)), Error);
  EXPECT_THROW((Torus<T>(1, 0)), Error);
  EXPECT_THROW((Torus<T>(inf, 1)), Error);
  EXPECT_THROW((Torus<T>(T(-1), T(-2))), Error);
  EXPECT_THROW((Torus<T>({0, 0, 0}, {0, 0, 0}, 2, 1)), Error);
  EXPECT_THROW((Torus<T>({nan, 0, 0}, {0, 0, 1}, 2, 1)), Error);
}

TYPED_TEST(TorusTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Torus<T>(1, T(0.4)), 2, {.inside = [](const Vec3<double>& p) {
                    const double ring = std::hypot(p.x, p.y) - 1;
                    return ring * ring + p.z * p.z < double(T(0.4)) * double(T(0.4));
                  }});
  expectGuarantee(Torus<T>({T(0.2), 0, T(-0.1)}, {1, 2, -2}, 1, T(0.25)), 2);
}

TYPED_TEST(TorusTest, ClosestPointsFromItsAxisAreOnTheInnerCircle) {
  using T = TypeParam;
  const Torus<T> torus(3, 1);
  for (const T z : {T(-4), T(0), T(1)}) {
    const auto c = torus.closestPoint({0, 0, z});
    EXPECT_TRUE(c.exact);
    const T away = std::hypot(T(3), z);  // toward the tube's centre line
    EXPECT_NEAR(c.point.z, z * (1 - (away - 1) / away), tolerance<T>(8));
    EXPECT_NEAR(std::hypot(c.point.x, c.point.y), 3 * (away - 1) / away, tolerance<T>(8));
  }
}

TEST(TorusRounding, StaysWithinItsBound) {
  expectRounding(Torus<float>(3, 1), Torus<double>(3, 1), 4);
  expectRounding(Torus<float>({9, 1, 2}, {1, 2, 3}, 3, 2.999f),
                 Torus<double>({9, 1, 2}, {1, 2, 3}, 3, 2.999f), 4);
  expectRounding(Torus<float>({0, 0, 0}, {1, 0, 0}, 1, 0.001f),
                 Torus<double>({0, 0, 0}, {1, 0, 0}, 1, 0.001f), 4);
}

}  // namespace
}  // namespace cutwater::test
