#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <algorithm>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// As little as a user has to write: nothing is promised.
template <typename T>
class Ball final : public SignedDistanceFunction<T> {
  T localSignedDistance(const Vec3<T>& p) const override { return length(p) - 1; }
};

/// The same with a promise, and still no gradient.
template <typename T>
class PromisingBall final : public SignedDistanceFunction<T> {
  T localSignedDistance(const Vec3<T>& p) const override { return length(p) - 1; }
  Guarantee<T> localGuarantee() const override { return Guarantee<T>::exact(1); }
};

/// f = x inside a box of validity, rubbish outside of it.
template <typename T>
class LocallyValid final : public SignedDistanceFunction<T> {
  T localSignedDistance(const Vec3<T>& p) const override {
    return maxComponent(abs(p)) <= 1 ? p.x : T(-7);
  }
  Guarantee<T> localGuarantee() const override {
    auto promise = Guarantee<T>::exact(1);
    promise.domain = {{-1, -1, -1}, {1, 1, 1}};
    return promise;
  }
};

/// Spins a wave of known crossings along x: sin(k x), 1-Lipschitz.
template <typename T>
class Wave final : public SignedDistanceFunction<T> {
 public:
  explicit Wave(T k) : k_(k) {}

 private:
  T localSignedDistance(const Vec3<T>& p) const override { return std::sin(k_ * p.x) / k_; }
  Guarantee<T> localGuarantee() const override {
    auto promise = Guarantee<T>::exact(4);
    promise.inside = promise.outside = Quality::LowerBound;
    return promise;
  }
  T k_;
};

template <typename T>
class SignedDistanceFunctionTest : public ::testing::Test {};
TYPED_TEST_SUITE(SignedDistanceFunctionTest, Precisions);

TYPED_TEST(SignedDistanceFunctionTest, MinimalSubclassGetsSoundDefaults) {
  using T = TypeParam;
  const Ball<T> ball;
  EXPECT_EQ(ball.guarantee().outside, Quality::SignOnly);
  EXPECT_FALSE(ball.guarantee().lipschitz);
  EXPECT_EQ(ball.boundingBox(), Box<T>::everywhere());
  EXPECT_EQ(ball.classify({{5, 5, 5}, {6, 6, 6}}), BoxClass::Unknown);
  EXPECT_EQ(ball.bounds({{5, 5, 5}, {6, 6, 6}}), Interval<T>::everything());
  EXPECT_NEAR(ball.gradient({0, 3, 4}).y, T(0.6), T(1e-3));
  EXPECT_NEAR(ball.normal({0, 3, 4}, T(0.01)).z, T(0.8), T(1e-4));
  EXPECT_EQ(ball.normal({0, 0, 0}, T(0.01)), Vec3<T>{});
  EXPECT_EQ(ball.normal({0, 3, 4}, T(0)), Vec3<T>{});
  EXPECT_EQ(ball.normal({0, 3, 4}, std::numeric_limits<T>::quiet_NaN()), Vec3<T>{});
  EXPECT_EQ(ball.patchNames(), std::vector<std::string>{"surface"});
  const auto c = ball.closestPoint({0, 3, 4});
  EXPECT_NEAR(c.point.z, T(0.8), T(1e-3));
  EXPECT_FALSE(c.exact);
  EXPECT_EQ(c.tolerance, std::numeric_limits<T>::infinity());
  std::size_t told = 0;
  const auto walk = ball.crossings({{-2, 0, 0}, {2, 0, 0}}, [&told](const Crossing<T>& x) {
    EXPECT_NEAR(std::abs(x.point.x), T(1), tolerance<T>(2));
    ++told;
    return true;
  });
  EXPECT_EQ(told, 2U);
  EXPECT_EQ(walk.unresolved, 1U) << "without a Lipschitz constant more cannot be excluded";
  expectGuarantee(ball, 2, {.inside = [](const Vec3<double>& p) { return length(p) < 1; }});
}

TYPED_TEST(SignedDistanceFunctionTest, PromiseAloneGivesExactAnswers) {
  using T = TypeParam;
  const PromisingBall<T> ball;
  EXPECT_EQ(ball.classify({{5, 5, 5}, {6, 6, 6}}), BoxClass::Outside);
  EXPECT_EQ(ball.classify({{0, 0, 0}, {T(0.1), T(0.1), T(0.1)}}), BoxClass::Inside);
  EXPECT_EQ(ball.classify({{0, 0, 0}, {2, 2, 2}}), BoxClass::Cut);
  // No corner is inside, and the centre is outside too.
  EXPECT_EQ(ball.classify({{-8, -7, -7}, {7, 9, 9}}), BoxClass::Cut);
  // The nearest surface point is nearly, but not, as near as the faces are to the centre.
  EXPECT_EQ(ball.classify({{T(1.03), -1, -1}, {T(3.03), 1, 1}}), BoxClass::Unknown);
  EXPECT_EQ(ball.classify({{T(0.97), -1, -1}, {T(2.97), 1, 1}}), BoxClass::Cut);
  const auto walk =
      ball.crossings({{-2, T(0.5), 0}, {2, T(0.5), 0}}, [](const auto&) { return true; });
  EXPECT_EQ(walk.found, 2U);
  EXPECT_EQ(walk.unresolved, 0U);
}

TYPED_TEST(SignedDistanceFunctionTest, BoxesBeyondTheDomainAreUnknown) {
  using T = TypeParam;
  const LocallyValid<T> f;
  EXPECT_EQ(f.classify({{T(0.5), 0, 0}, {T(0.6), T(0.1), T(0.1)}}), BoxClass::Outside);
  EXPECT_EQ(f.classify({{T(0.9), 0, 0}, {T(1.1), T(0.1), T(0.1)}}), BoxClass::Unknown);
  EXPECT_EQ(f.bounds({{T(0.9), 0, 0}, {T(1.1), T(0.1), T(0.1)}}), Interval<T>::everything());
}

/// A ball, promised to be exact within [-2, 2]^3 only; beyond are a steep slab and values that mean
/// nothing.
template <typename T>
class BallAndSlab final : public SignedDistanceFunction<T> {
 protected:
  T localSignedDistance(const Vec3<T>& p) const override {
    const T ball = length(p) - 1;
    const T slab = 100 * (std::abs(p.x - T(5.5)) - T(0.4));
    return maxComponent(abs(p)) > 2 && slab < 0 ? slab : ball;
  }
  Guarantee<T> localGuarantee() const override {
    auto promise = Guarantee<T>::exact(2);
    promise.domain = {{-2, -2, -2}, {2, 2, 2}};
    return promise;
  }
};

TYPED_TEST(SignedDistanceFunctionTest, PromisesNothingBeyondTheDomain) {
  using T = TypeParam;
  const BallAndSlab<T> solid;
  const auto keep = [](const Crossing<T>&) { return true; };
  const auto within = solid.crossings({{-2, 0, 0}, {2, T(0.1), 0}}, keep);
  EXPECT_EQ(within.found, 2U);
  EXPECT_EQ(within.unresolved, 0U);
  for (const Segment<T>& segment :
       {Segment<T>{{4, 0, 0}, {8, 0, 0}}, Segment<T>{{1.5, 0, 0}, {8, 0, 0}}}) {
    const auto beyond = solid.crossings(segment, keep);
    EXPECT_EQ(beyond.found, 2U);
    EXPECT_GE(beyond.unresolved, 1U) << "more cannot be excluded";
  }
  EXPECT_TRUE(solid.closestPoint({T(1.5), 0, 0}).exact);
  const auto beyond = solid.closestPoint({T(6.5), 0, 0});  // the slab is nearer than the ball
  EXPECT_FALSE(beyond.exact);
  EXPECT_EQ(beyond.tolerance, std::numeric_limits<T>::infinity());
}

TYPED_TEST(SignedDistanceFunctionTest, TolerancesIncludeTheRoundingOfThePlacement) {
  using T = TypeParam;
  PromisingBall<T> ball;
  ball.rotate(33, Vec3<T>{1, 2, 3});
  ball.translate({T(1e4), T(7e3), T(-3e3)});
  const auto center = Vec3<double>(ball.placement().offset());
  RandomPoints<T> random(3);
  for (int n = 0; n < 2000; ++n) {
    const auto p = ball.placement().offset() + random.next();
    const auto found = ball.closestPoint(p);
    const double distance = std::abs(length(Vec3<double>(p) - center) - 1);
    ASSERT_LE(length(Vec3<double>(found.point) - Vec3<double>(p)) - double{found.tolerance},
              distance);
    ASSERT_LE(double{found.tolerance}, 100 * double{ball.guarantee().error(length(p))});
  }
}

TYPED_TEST(SignedDistanceFunctionTest, FarBoxesAreNotCut) {
  using T = TypeParam;
  const PromisingBall<T> ball;
  const T far = std::numeric_limits<T>::max() / 4;
  EXPECT_NE(ball.classify({{far, far, far}, {2 * far, 2 * far, 2 * far}}), BoxClass::Cut);
}

TYPED_TEST(SignedDistanceFunctionTest, PointsThatAreNotFiniteHaveNoAnswers) {
  using T = TypeParam;
  const PromisingBall<T> ball;
  for (const T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()}) {
    const Vec3<T> p{0, bad, 0};
    EXPECT_TRUE(std::isnan(ball.signedDistance(p)));
    EXPECT_TRUE(std::isnan(ball.gradient(p).x));
    EXPECT_TRUE(std::isnan(ball.normal(p, T(0.1)).x));
    EXPECT_TRUE(std::isnan(ball.closestPoint(p).point.x));
    EXPECT_EQ(ball.closestPoint(p).owner.patch, kNone);
    EXPECT_EQ(ball.owner(p).patch, kNone);
  }
}

TYPED_TEST(SignedDistanceFunctionTest, FindsEveryCrossingInOrder) {
  using T = TypeParam;
  const T k = 100;
  const Wave<T> wave(k);
  std::vector<T> found;
  const auto visit = [&found](const Crossing<T>& c) {
    found.push_back(c.point.x);
    return true;
  };
  const auto walk = wave.crossings({{T(0.001), 0, 0}, {1, 0, 0}}, visit);
  ASSERT_EQ(found.size(), 31U);  // pi, 2 pi, ... 31 pi < 100
  EXPECT_EQ(walk.unresolved, 0U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], static_cast<double>(i + 1) * 3.14159265358979 / 100, tolerance<T>(4));
  }
  std::size_t told = 0;
  const auto stopped =
      wave.crossings({{T(0.001), 0, 0}, {1, 0, 0}}, [&told](const auto&) { return ++told < 3; });
  EXPECT_EQ(told, 3U);
  EXPECT_EQ(stopped.found, 3U);
}

TYPED_TEST(SignedDistanceFunctionTest, LimitsTheWorkForEndlesslyManyCrossings) {
  using T = TypeParam;
  // Periods shorter than any stretch: as good as noise, with a crossing in half of all stretches.
  std::size_t asked = 0;
  const auto wave = [&asked](const Vec3<T>& p) {
    ++asked;
    return std::sin(p.x);
  };
  const FunctionSDF solid(wave, Guarantee<T>{.lipschitz = T(1), .continuous = true});
  const T far = sizeof(T) == sizeof(float) ? T(1e5) : T(1e12);
  std::size_t told = 0;
  T before = 0;
  const Segment<T> segment{{T(-0.9) * far, 0, 0}, {far, 0, 0}};
  const auto walk = solid.crossings(segment, [&](const Crossing<T>& c) {
    EXPECT_GT(c.parameter, before);
    before = c.parameter;
    ++told;
    return true;
  });
  EXPECT_LT(asked, 220'000U);
  EXPECT_EQ(walk.found, told);
  EXPECT_GT(walk.found, 2000U);
  // Stretches side by side count as one; here no constant excludes crossings anywhere.
  EXPECT_GE(walk.unresolved, 1U);
  EXPECT_EQ(walk.found % 2 == 1, (std::sin(segment.start.x) < 0) != (std::sin(far) < 0));
}

TYPED_TEST(SignedDistanceFunctionTest, TellsWhereCrossingsCannotBeExcluded) {
  using T = TypeParam;
  const PromisingBall<T> ball;
  const auto any = [](const auto&) { return true; };
  const auto tangent = ball.crossings({{-2, 1, 0}, {2, 1, 0}}, any);
  EXPECT_EQ(tangent.found, 0U);
  EXPECT_EQ(tangent.unresolved, 1U);
  // Shallow cuts through the surface are resolved all the same.
  for (const T depth : {T(1e-2), T(1e-4)}) {
    const auto grazing = ball.crossings({{-2, 1 - depth, 0}, {2, 1 - depth, 0}}, any);
    EXPECT_EQ(grazing.found, 2U);
    EXPECT_EQ(grazing.unresolved, 0U) << depth;
    const auto passing = ball.crossings({{-2, 1 + depth, 0}, {2, 1 + depth, 0}}, any);
    EXPECT_EQ(passing.found + passing.unresolved, 0U) << depth;
  }
}

TYPED_TEST(SignedDistanceFunctionTest, AsksLittleWhereASegmentLiesInTheSurface) {
  using T = TypeParam;
  // The half-space z < 1, with a ramp that rises from x = 0.3 on; 1-Lipschitz.
  std::size_t asked = 0;
  const FunctionSDF ground(
      [&asked](const Vec3<T>& p) {
        ++asked;
        return T(0.8) * (p.z - 1 - std::max(T(0), (p.x - T(0.3)) / 2));
      },
      Guarantee<T>::exact(2));
  std::vector<T> found;
  const auto visit = [&found](const Crossing<T>& c) {
    found.push_back(c.point.x);
    return true;
  };
  EXPECT_EQ(ground.crossings({{-2, 0, 1}, {T(0.25), 0, 1}}, visit).unresolved, 1U);
  EXPECT_TRUE(found.empty());
  EXPECT_LT(asked, 100U);
  asked = 0;
  EXPECT_EQ(ground.crossings({{-2, 0, 1}, {1, 0, 1}}, visit).unresolved, 1U);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], 0.3, 1e-4);
  EXPECT_LT(asked, 2000U);
  // A wave that is zero wherever the segment is halved, 32 times, does not seem to be the surface.
  const auto waves = Wave<T>(T(32 * 3.14159265358979)).crossings({{}, {1, 0, 0}}, visit);
  EXPECT_EQ(waves.found, found.size() - 1);
  EXPECT_GE(waves.found, 31U);
  EXPECT_LE(waves.unresolved, 2U);  // the ends, where it is zero, too
}

TYPED_TEST(SignedDistanceFunctionTest, BatchesRefuseSpansOfDifferentSize) {
  using T = TypeParam;
  std::vector<Vec3<T>> points(3);
  std::vector<T> values(2);
  EXPECT_THROW(Ball<T>().signedDistances(points, values), Error);
  std::vector<SurfacePoint<T>> nearest(2);
  EXPECT_THROW(Ball<T>().closestPoints(points, nearest), Error);
}

TYPED_TEST(SignedDistanceFunctionTest, MotionsActInCallOrder) {
  using T = TypeParam;
  const auto center = [](const SignedDistanceFunction<T>& f) {
    return f.placement().toWorld(Vec3<T>{});
  };
  Ball<T> ball;
  ball.translate({1, 0, 0});
  ball.rotate(90, 2);  // first moved to x = 1, then swung about the z axis to y = 1
  EXPECT_EQ(center(ball), (Vec3<T>{0, 1, 0}));
  EXPECT_EQ(ball.signedDistance({0, 1, 0}), T(-1));
  EXPECT_EQ(ball.placement().toLocal({0, 1, 0}), Vec3<T>{});
  Ball<T> other;
  other.rotate(90, 2);
  other.translate({1, 0, 0});
  EXPECT_EQ(center(other), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(other.signedDistance({1, 0, 0}), T(-1));
  EXPECT_EQ(other.signedDistance({1, 4, 0}), T(3));
}

}  // namespace
}  // namespace cutwater::test
