#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Mirror.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MirrorTest : public ::testing::Test {
 protected:
  Sphere<T> ball_{{1, 0, 0}, 2};
  CappedCone<T> cone_{{0, T(0.25), 0}, {T(0.5), T(0.25), 1}, 1, T(0.5)};
};
TYPED_TEST_SUITE(MirrorTest, Precisions);

TYPED_TEST(MirrorTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto image = mirrored(this->ball_, {2, 0, 0}, {3, 0, 0});  // centre (5, 0, 0)
  EXPECT_EQ(image.signedDistance({5, 0, 0}), T(-2));
  EXPECT_EQ(image.signedDistance({9, 0, 0}), T(2));
  EXPECT_EQ(image.closestPoint({9, 0, 0}).point, (Vec3<T>{7, 0, 0}));
  EXPECT_EQ(image.closestPoint({9, 0, 0}).normal, (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(image.gradient({9, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(image.classify({{4, -1, -1}, {6, 1, 1}}), BoxClass::Inside);
  EXPECT_NEAR(image.boundingBox().lower.x, T(3), tolerance<T>(10, 256));
  image.crossings({{9, 0, 0}, {5, 0, 0}}, [](const Crossing<T>& c) {
    EXPECT_NEAR(c.point.x, T(7), tolerance<T>(10));
    EXPECT_NEAR(c.normal.x, T(1), tolerance<T>(1));
    EXPECT_TRUE(c.entering);
    return true;
  });
  const auto swappedAxes = mirrored(this->ball_, {1, -1, 0});  // x and y change places
  EXPECT_NEAR(swappedAxes.signedDistance({0, 1, 0}), T(-2), tolerance<T>(2));
  EXPECT_EQ(mirrored(Plane<T>({0, 0, 1}, {0, 0, 1}), {0, 0, 1}).boundingBox().upper.z,
            std::numeric_limits<T>::infinity());
}

TYPED_TEST(MirrorTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto image = mirrored(this->cone_, {1, -2, 3}, {T(0.25), T(0.5), T(0.75)});
  EXPECT_EQ(image.guarantee().outside, Quality::Exact);
  EXPECT_EQ(image.guarantee().inside, Quality::Exact);
  const Vec3<double> n = normalized(Vec3<double>{1, -2, 3});
  expectGuarantee(image, 3.5, {.inside = [&](const Vec3<double>& p) {
                    const auto q = p - 2 * dot(p - Vec3<double>{0.25, 0.5, 0.75}, n) * n;
                    return this->cone_.signedDistance(Vec3<T>(q)) < 0;
                  }});
  expectGuarantee(mirrored(this->cone_ | this->ball_, {0, 0, 1}, {0, 0, 2}), 7);
  expectGuarantee(translated(mirrored(this->ball_ - this->cone_, {1, 1, 0}), {1, 0, 0}), 4);
}

TYPED_TEST(MirrorTest, RoundsAsTheSameInDouble) {
  expectRounding(mirrored(Sphere<float>({1, 2, 3}, 1), {1, -2, 3}, {4, 5, 6}),
                 mirrored(Sphere<double>({1, 2, 3}, 1), {1, -2, 3}, {4, 5, 6}), 6);
}

TYPED_TEST(MirrorTest, TwiceIsTheSolidItselfToTheBit) {
  using T = TypeParam;
  const Vec3<T> normal{T(0.3), T(-0.7), T(0.1)};
  const Vec3<T> point{T(0.1), T(0.2), T(0.3)};
  const auto body = this->ball_ - this->cone_;
  const auto twice = mirrored(mirrored(body, normal, point), normal, point);
  // Two objects, with nothing but the formula; exact about a coordinate plane.
  const auto plain = Solid<T>(Mirror<T>(Mirror<T>(body, {}, {0, 1, 0}), {}, {0, 1, 0}));
  RandomPoints<T> points(3);
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    EXPECT_EQ(twice.signedDistance(p), body.signedDistance(p));
    EXPECT_EQ(plain.signedDistance(p), body.signedDistance(p));
    EXPECT_EQ(mirrored(body, {0, 0, 1}).signedDistance({p.x, p.y, -p.z}), body.signedDistance(p));
  }
  auto moved = mirrored(body, normal, point);
  moved.translate({1, 0, 0});
  EXPECT_NE(mirrored(moved, normal, point).template as<Mirror<T>>(), nullptr);
}

TYPED_TEST(MirrorTest, RefusesImpossiblePlanes) {
  using T = TypeParam;
  EXPECT_THROW(static_cast<void>(mirrored(this->ball_, {0, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(
                   mirrored(this->ball_, {1, 0, 0}, {std::numeric_limits<T>::infinity(), 0, 0})),
               Error);
}

}  // namespace
}  // namespace cutwater::test
