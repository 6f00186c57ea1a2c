#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class InversionTest : public ::testing::Test {
 protected:
  /// No value may exceed the known distance, and signs agree.
  void expectBound(const Solid<T>& image, const Solid<T>& exact, T extent) {
    RandomPoints<T> points(extent);
    for (int i = 0; i < 2000; ++i) {
      const auto p = points.next();
      const T value = image.signedDistance(p);
      const T distance = exact.signedDistance(p);
      const T rounding = 4 * image.guarantee().error(length(p));
      EXPECT_LE(std::abs(value), std::abs(distance) + rounding) << p;
      if (std::abs(distance) > rounding) {
        EXPECT_EQ(value < 0, distance < 0) << p;
      }
    }
  }
  Sphere<T> ball_{{3, 0, 0}, 1};
};
TYPED_TEST_SUITE(InversionTest, Precisions);

TYPED_TEST(InversionTest, TakesBallsAndPlanesToBalls) {
  using T = TypeParam;
  // The image of |q - c| = r is a sphere about c / (c^2 - r^2), of radius r / (c^2 - r^2).
  this->expectBound(inverted(this->ball_), Sphere<T>({T(0.375), 0, 0}, T(0.125)), 1);
  this->expectBound(inverted(this->ball_), Sphere<T>({T(0.375), 0, 0}, T(0.125)), 100);
  // Around the origin: outside of a ball.
  const Sphere<T> around({1, 0, 0}, 3);
  this->expectBound(inverted(around), ~Sphere<T>({T(-0.125), 0, 0}, T(0.375)), 2);
  this->expectBound(inverted(~around), Sphere<T>({T(-0.125), 0, 0}, T(0.375)), 2);
  // The half-space x > 1 is a ball through the origin.
  this->expectBound(inverted(Plane<T>({1, 0, 0}, {-1, 0, 0})), Sphere<T>({T(0.5), 0, 0}, T(0.5)),
                    3);
  // A ball through the origin becomes the half-space x > 1/2.
  this->expectBound(inverted(Sphere<T>({1, 0, 0}, 1)), Plane<T>({T(0.5), 0, 0}, {-1, 0, 0}), 3);
}

TYPED_TEST(InversionTest, ThePopularFormulaIsNoBound) {
  using T = TypeParam;
  const auto image = inverted(this->ball_);
  const Sphere<T> exact({T(0.375), 0, 0}, T(0.125));
  for (const T x : {T(4), T(30), T(1000)}) {
    const Vec3<T> p{0, x, 0};
    const T popular = this->ball_.signedDistance(p / (x * x)) * x * x;
    EXPECT_GT(popular, T(1.9) * x * exact.signedDistance(p));
    EXPECT_LE(image.signedDistance(p), exact.signedDistance(p));
    EXPECT_GT(image.signedDistance(p), T(0.4) * exact.signedDistance(p));
  }
}

TYPED_TEST(InversionTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto image = inverted(this->ball_);
  EXPECT_EQ(image.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(image.guarantee().lipschitz, T(1));
  expectGuarantee(image, 0.75);
  expectGuarantee(inverted(Torus<T>(2, T(0.5))), 1.25, {.inside = [](const Vec3<double>& p) {
                    const auto q = p / dot(p, p);
                    return std::hypot(std::hypot(q.x, q.y) - 2, q.z) < 0.5;
                  }});
  const Cuboid<T> box({T(-0.5), -1, -1}, {1, 2, 1});  // holds the origin: the image is unbounded
  expectGuarantee(inverted(box), 3, {.inside = [&](const Vec3<double>& p) {
                    const auto q = p / dot(p, p);
                    return q.x > -0.5 && q.x < 1 && q.y > -1 && q.y < 2 && std::abs(q.z) < 1;
                  }});
  expectGuarantee(inverted(~box), 3);
  // Bounds only, and an unbounded operand.
  expectGuarantee(inverted(translated(box, {2, 0, 0}) - this->ball_), 1.5);
  expectGuarantee(inverted(Plane<T>({0, 1, 0}, {0, 1, T(0.5)})), 2);
  expectGuarantee(translated(rotated(inverted(this->ball_ | box), 20, {1, 2, 3}), {1, 0, 0}), 3);
}

TYPED_TEST(InversionTest, OfABoundKeepsItsLipschitzConstant) {
  using T = TypeParam;
  // Near the centre of what is cut off, the value is as deep as the solid is far: with the radius
  // of the surface, the bound would change 80 times as fast as the point.
  const auto cap = Sphere<T>({0, 0, 0}, 1) - Sphere<T>({-40, 0, 0}, 40);
  const auto image = inverted(cap);
  EXPECT_EQ(image.guarantee().lipschitz, T(1));
  const Vec3<T> p{T(-1 / 40.1), 0, 0};
  const Vec3<T> q{T(-1 / 40.4), 0, 0};
  EXPECT_LE(std::abs(image.signedDistance(p) - image.signedDistance(q)), T(1.1) * length(p - q));
}

TYPED_TEST(InversionTest, TheOriginStandsForInfinity) {
  using T = TypeParam;
  const auto image = inverted(this->ball_);
  const T atOrigin = image.signedDistance({0, 0, 0});
  EXPECT_GT(atOrigin, T(0.15));
  EXPECT_LE(atOrigin, T(0.25));
  for (const T tiny : {std::numeric_limits<T>::denorm_min(), T(1e-30), T(1e-9), T(1e-5)}) {
    EXPECT_NEAR(image.signedDistance({tiny, -tiny, 0}), atOrigin, 2 * tiny + tolerance<T>(1));
  }
  EXPECT_LT((inverted(~this->ball_)).signedDistance({0, 0, 0}), T(0));
  EXPECT_EQ(inverted(Plane<T>({1, 0, 0}, {-1, 0, 0})).signedDistance({0, 0, 0}), T(0));
  EXPECT_EQ(image.gradient({0, 0, 0}), Vec3<T>{});
}

TYPED_TEST(InversionTest, BoundingBoxesAreFiniteAwayFromTheOrigin) {
  using T = TypeParam;
  const auto box = inverted(this->ball_).boundingBox();
  EXPECT_NEAR(box.upper.x, T(0.5), tolerance<T>(1, 4096));
  EXPECT_EQ(inverted(Sphere<T>({1, 0, 0}, 3)).boundingBox(), Box<T>::everywhere());
}

TYPED_TEST(InversionTest, RoundsAsTheSameInDouble) {
  expectRounding(inverted(Sphere<float>({3, 0, 0}, 1)), inverted(Sphere<double>({3, 0, 0}, 1)), 1);
  expectRounding(inverted(Torus<float>(2, 0.5F)), inverted(Torus<double>(2, 0.5)), 1);
}

}  // namespace
}  // namespace cutwater::test
