#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DerivedGuaranteeTest : public ::testing::Test {
 protected:
  /// A ball whose promise holds in a box; values outside of it are wrong by 1000.
  Solid<T> limited() const {
    auto promise = Guarantee<T>::exact(1);
    promise.domain = {{T(-2), T(-2.5), T(-1.5)}, {2, T(2.5), 2}};
    const auto value = [domain = promise.domain](const Vec3<T>& p) {
      return length(p) - 1 + (domain.contains(p) ? T(0) : T(1000));
    };
    return FunctionSDF(value, promise, {{-1, -1, -1}, {1, 1, 1}});
  }

  /// The domain is no larger than where values are right, and boxes that reach out of it are not
  /// decided.
  void expectDomain(const Solid<T>& solid, double leastShare) {
    const auto domain = solid.guarantee().domain;
    EXPECT_NE(domain, Box<T>::everywhere());
    RandomPoints<T> points(4);
    int within = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto p = points.next();
      // Rounding may put a point on the domain's boundary to either side.
      const bool isWithin = domain.grown(T(-1e-4)).contains(p);
      within += isWithin ? 1 : 0;
      if (isWithin) {
        EXPECT_LT(std::abs(solid.signedDistance(p)), T(100)) << p;
      }
      const auto box = Box<T>{p, p}.grown(T(0.5));
      if (domain.contains(box.lower) && domain.contains(box.upper)) continue;
      const auto range = solid.bounds(box);
      for (int corner = 0; corner < 8; ++corner) {
        EXPECT_TRUE(range.contains(solid.signedDistance(box.corner(corner)))) << p;
      }
    }
    EXPECT_GE(within, leastShare * 4000);
  }

  Cuboid<T> box_{{T(0.25), -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(DerivedGuaranteeTest, Precisions);

TYPED_TEST(DerivedGuaranteeTest, DomainsFollowThePoints) {
  using T = TypeParam;
  const auto ball = this->limited();
  const Vec3<T> oblique{1, 2, T(-0.5)};
  this->expectDomain(ball, 0.12);
  this->expectDomain(translated(ball, {1, 0, 0}), 0.12);
  this->expectDomain(rotated(ball, 90, 0), 0.12);
  auto half = Guarantee<T>::exact(1);
  half.domain.lower.x = 0;  // what is infinite stays so where nothing turns
  const Solid<T> open = FunctionSDF([](const Vec3<T>& p) { return p.x; }, half);
  EXPECT_EQ(translated(open, {3, 0, 0}).guarantee().domain.lower.x, T(3));
  EXPECT_EQ(translated(open, {3, 0, 0}).guarantee().domain.upper, Box<T>::everywhere().upper);
  this->expectDomain(rotated(ball, 30, oblique), 0.02);
  this->expectDomain(mirrored(ball, {1, 0, 0}, {T(0.5), 0, 0}), 0.12);
  this->expectDomain(mirrored(ball, oblique), 0.02);
  const AffineMap<T> map{{{{1, T(0.25), 0}, {T(0.5), T(-1.5), 0}, {0, T(0.25), T(0.75)}}},
                         {T(0.5), 0, T(0.25)}};
  this->expectDomain(transformed(ball, map), 0.01);
  this->expectDomain(folded(ball, {0, 0, -1}), 0.1);
  this->expectDomain(elongated(ball, {1, 0, 0}), 0.12);
  const auto waves = [](const Vec3<T>& p) { return Vec3<T>{0, T(0.25) * std::sin(p.x), 0}; };
  this->expectDomain(warped(ball, waves, {.lipschitz = T(0.25), .amplitude = T(0.25)}), 0.06);
  this->expectDomain(warped(ball, waves, {.lipschitz = T(0.25)}), 0);
  this->expectDomain(inverted(ball), 0);
  this->expectDomain(repeated(ball, {.period = {3, 3, 3}}), 0);
}

TYPED_TEST(DerivedGuaranteeTest, DomainsOfSeveralAreTheCommonOne) {
  using T = TypeParam;
  const auto ball = this->limited();
  const auto other = translated(this->limited(), {T(0.5), 0, 0});
  for (const auto& solid : {ball | other, ball ^ other, smoothUnion(ball, other, {.reach = T(0.5)}),
                            smoothDifference(ball, other, {.reach = T(0.5)}),
                            blended(ball, other, T(0.5)), shell(ball ^ this->box_, T(0.25))}) {
    this->expectDomain(solid, 0.08);
  }
  const auto common = detail::common(
      Guarantee<T>::exact(2), Guarantee<T>{.lipschitz = T(3), .continuous = true, .ulps = 99});
  EXPECT_EQ(common.lipschitz, T(3));
  EXPECT_EQ(common.outside, Quality::SignOnly);
  EXPECT_EQ(common.ulps, T(99));
  EXPECT_EQ(common.size, T(2));
  EXPECT_TRUE(common.continuous);
}

}  // namespace
}  // namespace cutwater::test
