#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Operations/Detail/SmoothMinimum.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <algorithm>

#include "Support/CountedBall.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

constexpr SmoothKind kKinds[] = {SmoothKind::Quadratic, SmoothKind::Cubic, SmoothKind::Circular,
                                 SmoothKind::Exponential};

/// What SmoothCombination documents for a union: all values sorted, or in order, and folded.
template <typename T>
T plainFold(const std::vector<Solid<T>>& solids, const Vec3<T>& p, const Smoothing<T>& smoothing) {
  std::vector<T> values;
  for (const auto& solid : solids) values.push_back(solid.signedDistance(p));
  if (smoothing.kind != SmoothKind::Exponential) std::sort(values.begin(), values.end());
  detail::SmoothMinimum<T> sum(smoothing, values[0]);
  for (std::size_t i = 1; i < values.size(); ++i) static_cast<void>(sum.add(values[i]));
  return sum.value();
}

template <typename T>
class SmoothCombinationTest : public ::testing::Test {
 protected:
  std::vector<Solid<T>> balls(std::size_t count, T extent) const {
    RandomPoints<T> centers(extent, 3);
    std::vector<Solid<T>> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(Sphere<T>(centers.next(), T(0.5)));
    return all;
  }

  Sphere<T> left_{{-1, 0, 0}, 2};
  Sphere<T> right_{{1, 0, 0}, 2};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
  Torus<T> ring_{T(1.5), T(0.5)};
  Cylinder<T> pipe_{{-2, T(0.1), 0}, {2, T(0.1), T(0.3)}, T(0.5)};
};
TYPED_TEST_SUITE(SmoothCombinationTest, Precisions);

TYPED_TEST(SmoothCombinationTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto both = smoothUnion(this->left_, this->right_, {.reach = 1});
  EXPECT_EQ(both.signedDistance({0, 0, 0}), T(-1.25));  // -1 from each, k/4 below
  EXPECT_EQ(both.signedDistance({5, 0, 0}), T(2));      // the other is out of reach
  EXPECT_EQ(both.gradient({5, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(both.gradient({0, 0, 0}), (Vec3<T>{0, 0, 0}));
  const auto lens = smoothIntersection(this->left_, this->right_, {.reach = 1});
  EXPECT_EQ(lens.signedDistance({0, 0, 0}), T(-0.75));
  const auto moon = smoothDifference(this->left_, this->right_, {.reach = 2});
  EXPECT_EQ(moon.signedDistance({0, 0, 0}), T(1));         // of -1 and 1: as far apart as the reach
  EXPECT_EQ(moon.signedDistance({T(0.5), 0, 0}), T(1.5));  // deep in the right one
}

TYPED_TEST(SmoothCombinationTest, KeepsItsGuarantee) {
  using T = TypeParam;
  for (const auto kind : kKinds) {
    const Smoothing<T> smoothing{T(0.6), kind};
    const auto whole = smoothUnionOf<T>({this->box_, this->ring_, this->pipe_}, smoothing);
    EXPECT_EQ(whole.guarantee().lipschitz, T(1));
    EXPECT_EQ(whole.guarantee().outside, Quality::LowerBound);
    EXPECT_EQ(whole.guarantee().inside, Quality::LowerBound);
    const GuaranteeOptions options{.probes = 4000};
    expectGuarantee(whole, 3.5, options);
    expectGuarantee(smoothIntersection(this->box_, this->left_, smoothing), 2, options);
    expectGuarantee(smoothDifference(this->box_, this->pipe_, smoothing), 2, options);
    expectGuarantee(translated(rotated(whole, 30, {1, 2, 3}), {1, 0, 0}), 4.5, options);
  }
}

TYPED_TEST(SmoothCombinationTest, RoundsAsTheSameInDouble) {
  for (const auto kind : kKinds) {
    const auto make = [&]<typename S>(S) {
      std::vector<Solid<S>> solids;
      for (int i = 0; i < 12; ++i) solids.push_back(Sphere<S>({S(i) / 8, 0, S(i % 3)}, 1));
      return smoothUnionOf<S>(solids, {S(0.5), kind});
    };
    expectRounding(make(float{}), make(double{}), 2);
  }
}

TYPED_TEST(SmoothCombinationTest, WithoutReachIsThePlainOperator) {
  using T = TypeParam;
  const auto plain = smoothUnion(this->box_, this->ring_, {});
  ASSERT_NE(plain.template as<Combination<T>>(), nullptr);
  EXPECT_EQ(plain.template as<Combination<T>>()->decides(), Combination<T>::Decides::Least);
  EXPECT_EQ(plain.guarantee(), (this->box_ | this->ring_).guarantee());
  RandomPoints<T> points(3);
  for (int i = 0; i < 500; ++i) {
    const auto p = points.next();
    EXPECT_EQ(plain.signedDistance(p), (this->box_ | this->ring_).signedDistance(p));
    EXPECT_EQ(smoothDifference(this->box_, this->ring_, {}).signedDistance(p),
              (this->box_ - this->ring_).signedDistance(p));
  }
}

TYPED_TEST(SmoothCombinationTest, ObeysDeMorganToTheBit) {
  using T = TypeParam;
  RandomPoints<T> points(3);
  for (const auto kind : kKinds) {
    const Smoothing<T> smoothing{T(0.7), kind};
    const auto common = smoothIntersection(this->box_, this->ring_, smoothing);
    const auto rest = ~smoothUnion(~this->box_, ~this->ring_, smoothing);
    const auto less = smoothDifference(this->box_, this->ring_, smoothing);
    const auto same = ~smoothUnion(~this->box_, this->ring_, smoothing);
    for (int i = 0; i < 300; ++i) {
      const auto p = points.next();
      EXPECT_EQ(common.signedDistance(p), rest.signedDistance(p));
      EXPECT_EQ(less.signedDistance(p), same.signedDistance(p));
    }
  }
}

TYPED_TEST(SmoothCombinationTest, CountsEveryOperandWithinReach) {
  using T = TypeParam;
  // 60 balls with one centre: more than are kept at a time, and all count.
  const std::vector<Solid<T>> same(60, Solid<T>(this->left_));
  const auto whole = smoothUnionOf<T>(same, {.reach = 1});
  const Vec3<T> p{4, 0, 0};
  EXPECT_EQ(whole.signedDistance(p), plainFold<T>(same, p, {.reach = 1}));
  EXPECT_LT(whole.signedDistance(p), T(3) - T(0.9));
  EXPECT_GT(whole.signedDistance(p), T(3) - T(1));
  // The nearest two alone would leave the value k/4 below, and jump where the two change.
  EXPECT_EQ(plainFold<T>({same[0], same[1]}, p, {.reach = 1}), T(2.75));
}

TYPED_TEST(SmoothCombinationTest, HasTheBitsOfThePlainFold) {
  using T = TypeParam;
  for (const auto kind : kKinds) {
    for (const std::size_t count : {3U, 40U, 3000U}) {
      const T extent = count == 3000U ? T(10) : T(1);
      const auto solids = this->balls(count, extent);
      const Smoothing<T> smoothing{T(0.4), kind};
      const auto whole = smoothUnionOf<T>(solids, smoothing);
      std::vector<Solid<T>> complements;
      for (const auto& solid : solids) complements.push_back(~solid);
      const auto holes = smoothIntersectionOf<T>(complements, smoothing);
      RandomPoints<T> points(T(1.5) * extent);
      for (int i = 0; i < 200; ++i) {
        const auto p = points.next();
        const T expected = plainFold<T>(solids, p, smoothing);
        EXPECT_EQ(whole.signedDistance(p), expected) << count << " at " << p;
        EXPECT_EQ(holes.signedDistance(p), -expected);
      }
    }
  }
}

TYPED_TEST(SmoothCombinationTest, DoesNotDependOnTheOrder) {
  using T = TypeParam;
  const auto solids = this->balls(50, 1);
  const std::vector<Solid<T>> reversed(solids.rbegin(), solids.rend());
  for (const auto kind : kKinds) {
    const Smoothing<T> smoothing{T(0.4), kind};
    const auto whole = smoothUnionOf<T>(solids, smoothing);
    const auto other = smoothUnionOf<T>(reversed, smoothing);
    RandomPoints<T> points(2);
    for (int i = 0; i < 200; ++i) {
      const auto p = points.next();
      const T allowed = kind == SmoothKind::Exponential ? tolerance<T>(4, 64) : T(0);
      EXPECT_NEAR(whole.signedDistance(p), other.signedDistance(p), allowed);
    }
  }
}

TYPED_TEST(SmoothCombinationTest, BoundsOfManyAreNoLooserThanTheDefault) {
  using T = TypeParam;
  const auto whole = smoothUnionOf<T>(this->balls(500, 4), {.reach = T(0.4)});
  RandomPoints<T> points(5);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    const auto box = Box<T>{p, p}.grown(T(i % 10) / 20);
    const auto range = whole.bounds(box);
    const T radius = length(box.upper - p);
    EXPECT_GE(range.lower, whole.signedDistance(p) - radius - 2 * whole.guarantee().error(12));
    EXPECT_LE(range.upper, whole.signedDistance(p) + radius + 2 * whole.guarantee().error(12));
    for (int corner = 0; corner < 8; ++corner) {
      EXPECT_TRUE(range.contains(whole.signedDistance(box.corner(corner))));
    }
  }
}

TYPED_TEST(SmoothCombinationTest, ChainsAskEachOperandOnceForABox) {
  using T = TypeParam;
  std::size_t calls = 0;
  auto chain = countedBall<T>(calls);
  for (int n = 0; n < 16; ++n)
    chain = smoothUnion(chain, Sphere<T>({T(n), 0, 0}, 1), {.reach = T(0.1)});
  EXPECT_EQ(chain.classify({{50, 50, 50}, {51, 51, 51}}), BoxClass::Outside);
  EXPECT_LT(calls, 100U);
}

TYPED_TEST(SmoothCombinationTest, TellsPatchesAndBoundingBoxes) {
  using T = TypeParam;
  const auto body =
      smoothUnion(named(this->left_, "port"), named(this->right_, "starboard"), {.reach = T(0.5)});
  EXPECT_EQ(body.patchNames(), (std::vector<std::string>{"port", "starboard"}));
  EXPECT_EQ(body.closestPoint({7, 0, 0}).owner.patch, 1U);
  EXPECT_TRUE(body.closestPoint({7, 0, 0}).exact);
  EXPECT_EQ(body.closestPoint({-7, 0, 0}).owner.patch, 0U);
  EXPECT_NEAR(body.boundingBox().upper.x, T(3.125), tolerance<T>(4, 64));  // k/4 more
  const auto lens = smoothIntersection(this->left_, this->right_, {.reach = T(0.5)});
  EXPECT_NEAR(lens.boundingBox().upper.x, T(1), tolerance<T>(4, 64));
  const auto open = smoothUnion(this->left_, Plane<T>({0, 0, 0}, {0, 0, 1}), {.reach = 1});
  EXPECT_EQ(open.boundingBox().lower.z, -std::numeric_limits<T>::infinity());
  EXPECT_NEAR(open.boundingBox().upper.z, T(2.25), tolerance<T>(4, 64));
}

TYPED_TEST(SmoothCombinationTest, RefusesImpossibleReaches) {
  using T = TypeParam;
  for (const T bad :
       {T(-1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(smoothUnion(this->box_, this->ring_, {.reach = bad})), Error);
  }
  EXPECT_THROW(static_cast<void>(smoothUnionOf<T>({}, {.reach = 1})), Error);
}

}  // namespace
}  // namespace cutwater::test
