#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SymmetricDifferenceTest : public ::testing::Test {
 protected:
  Sphere<T> left_{{-1, 0, 0}, 2};
  Sphere<T> right_{{1, 0, 0}, 2};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(SymmetricDifferenceTest, Precisions);

TYPED_TEST(SymmetricDifferenceTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto moons = this->left_ ^ this->right_;
  EXPECT_EQ(moons.signedDistance({0, 0, 0}), T(1));    // in both
  EXPECT_EQ(moons.signedDistance({2, 0, 0}), T(-1));   // in the right one, as near to both surfaces
  EXPECT_EQ(moons.signedDistance({-2, 0, 0}), T(-1));  // in the left one
  EXPECT_EQ(moons.signedDistance({5, 0, 0}), T(2));
  EXPECT_EQ(moons.closestPoint({T(0.75), 0, 0}).point, (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(moons.closestPoint({T(0.75), 0, 0}).normal, (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(moons.closestPoint({T(0.75), 0, 0}).owner.object, 0U);
  EXPECT_EQ(moons.gradient({T(0.75), 0, 0}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(moons.closestPoint({4, 0, 0}).owner.patch, 1U);
  EXPECT_EQ(moons.owner({3, 0, 0}).patch, 1U);
  EXPECT_NEAR(moons.boundingBox().upper.x, T(3), tolerance<T>(4, 64));
}

TYPED_TEST(SymmetricDifferenceTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const Torus<T> ring(T(1.5), T(0.5));
  const Cylinder<T> pipe({-2, T(0.1), 0}, {2, T(0.1), T(0.3)}, T(0.5));
  const auto in = [](const auto& solid, const Vec3<double>& p) {
    return solid.signedDistance(Vec3<T>(p)) < 0;
  };
  const auto whole = this->box_ ^ ring;
  EXPECT_EQ(whole.guarantee().outside, Quality::Exact);
  EXPECT_EQ(whole.guarantee().inside, Quality::Exact);
  expectGuarantee(whole, 3, {.inside = [&](const Vec3<double>& p) {
                    return in(this->box_, p) != in(ring, p);
                  }});
  const auto three = this->box_ ^ ring ^ pipe;
  expectGuarantee(three, 3, {.inside = [&](const Vec3<double>& p) {
                    return (in(this->box_, p) != in(ring, p)) != in(pipe, p);
                  }});
  const auto bound = (this->box_ | pipe) ^ ring;
  EXPECT_EQ(bound.guarantee().outside, Quality::LowerBound);
  expectGuarantee(translated(rotated(bound, 30, {1, 2, 3}), {1, 0, 0}), 4);
  expectGuarantee(this->box_ ^ ~ring, 3);
}

TYPED_TEST(SymmetricDifferenceTest, IsItsDefinitionToTheBit) {
  using T = TypeParam;
  const Torus<T> ring(T(1.5), T(0.5));
  const auto a = rotated(this->box_, 20, 0);
  const auto whole = symmetricDifference(a, ring);
  RandomPoints<T> points(3);
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    const T value = whole.signedDistance(p);
    EXPECT_EQ(value, ((a | ring) - (a & ring)).signedDistance(p));
    EXPECT_EQ(value, (ring ^ a).signedDistance(p));
    EXPECT_EQ(value, (~a ^ ~ring).signedDistance(p));
    EXPECT_EQ(-value, (~a ^ ring).signedDistance(p));
    EXPECT_EQ((a ^ ring ^ ring).signedDistance(p) < 0, a.signedDistance(p) < 0);
  }
}

TYPED_TEST(SymmetricDifferenceTest, OfASolidWithItselfIsEmpty) {
  using T = TypeParam;
  const auto none = this->left_ ^ this->left_;
  RandomPoints<T> points(4);
  for (int i = 0; i < 1000; ++i) EXPECT_GE(none.signedDistance(points.next()), T(0));
  // The false zero that is left, at x = 1, is no surface.
  EXPECT_EQ(none.classify({{T(0.9), T(-0.1), T(-0.1)}, {T(1.1), T(0.1), T(0.1)}}),
            BoxClass::Unknown);
  EXPECT_EQ(none.classify({{-1, 0, 0}, {0, 1, 1}}), BoxClass::Outside);
}

TYPED_TEST(SymmetricDifferenceTest, ClassifiesByItsOperands) {
  using T = TypeParam;
  const auto moons = this->left_ ^ this->right_;
  const T y = T(0.1);
  EXPECT_EQ(moons.classify({{0, 0, 0}, {y, y, y}}), BoxClass::Outside);
  EXPECT_EQ(moons.classify({{T(1.5), 0, 0}, {T(2.5), y, y}}), BoxClass::Inside);
  EXPECT_EQ(moons.classify({{T(0.5), 0, 0}, {T(1.5), y, y}}), BoxClass::Cut);
}

}  // namespace
}  // namespace cutwater::test
