#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FoldTest : public ::testing::Test {
 protected:
  Sphere<T> ball_{{2, 0, 0}, 1};
  Cuboid<T> box_{{0, -1, -1}, {1, 1, 1}};
  CappedCone<T> cone_{{0, T(0.25), 0}, {T(0.5), T(0.25), 1}, 1, T(0.5)};
};
TYPED_TEST_SUITE(FoldTest, Precisions);

TYPED_TEST(FoldTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto two = folded(this->ball_, {1, 0, 0});
  EXPECT_EQ(two.signedDistance({-2, 0, 0}), T(-1));
  EXPECT_EQ(two.signedDistance({2, 0, 0}), T(-1));
  EXPECT_EQ(two.signedDistance({0, 0, 0}), T(1));
  EXPECT_EQ(two.gradient({-4, 0, 0}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(two.closestPoint({-4, 0, 0}).point, (Vec3<T>{-3, 0, 0}));
  EXPECT_NEAR(two.boundingBox().lower.x, T(-3), tolerance<T>(4, 256));
  const auto none = folded(this->ball_, {-1, 0, 0});  // the other side is kept, and empty
  EXPECT_EQ(none.signedDistance({2, 0, 0}), T(3));
  EXPECT_TRUE(none.boundingBox().empty());
}

TYPED_TEST(FoldTest, DerivesItsGuarantee) {
  using T = TypeParam;
  const auto check = [](const auto& solid, Quality outside, Quality inside) {
    EXPECT_EQ(solid.guarantee().outside, outside);
    EXPECT_EQ(solid.guarantee().inside, inside);
  };
  check(folded(this->ball_, {1, 0, 0}), Quality::Exact, Quality::Exact);
  check(folded(this->box_, {1, 0, 0}), Quality::Exact, Quality::LowerBound);
  check(folded(this->cone_, {1, 0, 0}), Quality::LowerBound, Quality::LowerBound);
  check(folded(~this->ball_, {1, 0, 0}), Quality::LowerBound, Quality::LowerBound);
  check(unfolded(this->cone_, {1, 0, 0}), Quality::Exact, Quality::LowerBound);
  check(folded(translated(this->box_, {T(-0.001), 0, 0}), {1, 0, 0}), Quality::LowerBound,
        Quality::LowerBound);
}

TYPED_TEST(FoldTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(folded(this->ball_, {1, 0, 0}), 4);
  expectGuarantee(folded(this->box_, {1, 0, 0}), 2);
  const Vec3<double> n = normalized(Vec3<double>{1, -2, 3});
  const Vec3<double> at{0.25, 0, 0.5};
  const auto fold = folded(this->cone_, Vec3<T>{1, -2, 3}, Vec3<T>{T(0.25), 0, T(0.5)});
  expectGuarantee(fold, 3, {.inside = [&](const Vec3<double>& p) {
                    const double height = dot(p - at, n);
                    const auto q = height < 0 ? p - 2 * height * n : p;
                    return this->cone_.signedDistance(Vec3<T>(q)) < 0;
                  }});
  expectGuarantee(translated(folded(this->cone_ - this->ball_, {0, 1, 1}), {1, 0, 0}), 3);
  expectGuarantee(unfolded(this->cone_, {1, 0, 1}), 3);
}

TYPED_TEST(FoldTest, HoldsWhatASlightlyTiltedPlaneKeeps) {
  using T = TypeParam;
  const T tilt = std::sqrt(std::numeric_limits<T>::epsilon()) / 2;
  const auto solid = folded(Cuboid<T>({-5, -1, -1}, {-tilt / 4, 1, 1}), {1, tilt, 0});
  const Vec3<T> p{-tilt / 2, T(0.9), 0};
  EXPECT_LT(solid.signedDistance(p), T(0));
  EXPECT_TRUE(solid.boundingBox().contains(p));
}

TYPED_TEST(FoldTest, TwiceIsOnceToTheBit) {
  using T = TypeParam;
  const auto once = folded(this->cone_, {0, 1, 0});
  const auto twice = folded(once, {0, 1, 0});
  RandomPoints<T> points(3);
  for (int i = 0; i < 500; ++i) {
    const auto p = points.next();
    EXPECT_EQ(twice.signedDistance(p), once.signedDistance(p));
    EXPECT_EQ(once.signedDistance({p.x, -p.y, p.z}), once.signedDistance(p));
    EXPECT_EQ(once.signedDistance({p.x, std::abs(p.y), p.z}),
              this->cone_.signedDistance({p.x, std::abs(p.y), p.z}));
  }
}

TYPED_TEST(FoldTest, RefusesImpossiblePlanes) {
  EXPECT_THROW(static_cast<void>(folded(this->ball_, {0, 0, 0})), Error);
}

}  // namespace
}  // namespace cutwater::test
