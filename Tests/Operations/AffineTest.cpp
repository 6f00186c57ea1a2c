#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/CountedBall.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
AffineMap<T> stretch(T x, T y, T z, const Vec3<T>& offset = {}) {
  return {{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}, offset};
}

template <typename T>
class AffineTest : public ::testing::Test {
 protected:
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
  Torus<T> ring_{1, T(0.5)};
  /// Shears, stretches and mirrors.
  AffineMap<T> oblique_{{{{1, T(0.25), 0}, {T(0.5), T(-1.5), 0}, {0, T(0.25), T(0.75)}}},
                        {T(0.5), 0, T(0.25)}};
};
TYPED_TEST_SUITE(AffineTest, Precisions);

TYPED_TEST(AffineTest, MapsPointsDirectionsAndBoxes) {
  using T = TypeParam;
  const auto& map = this->oblique_;
  EXPECT_EQ(map(Vec3<T>{1, 2, 4}), (Vec3<T>{2.5, T(-1.75), 3.25}));
  EXPECT_EQ(map.direction({0, 1, 0}), map.columns[1]);
  EXPECT_EQ(map.transposed({1, 0, 0}), (Vec3<T>{1, T(0.5), 0}));  // the first row
  const auto box = map(Box<T>{{0, 0, 0}, {1, 1, 1}});
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(box.contains(map(Box<T>{{0, 0, 0}, {1, 1, 1}}.corner(i))));
  }
  EXPECT_NEAR(box.lower.y, T(-1.5), tolerance<T>(4));
  EXPECT_EQ(map(Box<T>::everywhere()), Box<T>::everywhere());
  EXPECT_TRUE(map(Box<T>{}).empty());
}

TYPED_TEST(AffineTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto near = [](T value, T expected) { EXPECT_NEAR(value, expected, tolerance<T>(4)); };
  const auto ball = Sphere<T>({0, 0, 0}, 1);
  const auto pill = transformed(ball, stretch<T>(4, 1, 1, {10, 0, 0}));  // the least stretch is 1
  near(pill.signedDistance({10, 0, 0}), T(-1));
  near(pill.signedDistance({10, 3, 0}), T(2));  // exact across, a bound along
  near(pill.signedDistance({18, 0, 0}), T(1));
  const auto disc = transformed(ball, stretch<T>(1, 1, T(-0.25)));
  near(disc.signedDistance({0, 0, 1}), T(0.75));
  near(disc.signedDistance({3, 0, 0}), T(0.5));
  EXPECT_NEAR(disc.boundingBox().upper.z, T(0.25), tolerance<T>(4, 256));
  near(disc.closestPoint({0, 0, 1}).point.z, T(0.25));
  EXPECT_TRUE(disc.closestPoint({0, 0, 1}).exact);
}

TYPED_TEST(AffineTest, IsNeverMoreThanTheDistance) {
  using T = TypeParam;
  // A stretched box is a box, whose distance is known.
  const auto flat = transformed(this->box_, stretch<T>(2, 1, T(0.25)));
  const Cuboid<T> exact({-2, -1, T(-0.25)}, {2, 1, T(0.25)});
  RandomPoints<T> points(4);
  int tooLarge = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    const T value = flat.signedDistance(p);
    const T distance = exact.signedDistance(p);
    EXPECT_EQ(value < 0, distance < 0) << p;
    EXPECT_LE(std::abs(value), std::abs(distance) + tolerance<T>(4));
    // Control: the operand's value alone is no bound.
    tooLarge += std::abs(4 * value) > std::abs(distance) + tolerance<T>(8) ? 1 : 0;
  }
  EXPECT_GT(tooLarge, 500);
}

TYPED_TEST(AffineTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto image = transformed(this->ring_, this->oblique_);
  EXPECT_EQ(image.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(image.guarantee().inside, Quality::LowerBound);
  // The inverse by Cramer's rule, in double.
  const Vec3<double> a(this->oblique_.columns[0]);
  const Vec3<double> b(this->oblique_.columns[1]);
  const Vec3<double> c(this->oblique_.columns[2]);
  const double det = dot(a, cross(b, c));
  EXPECT_LT(det, 0);
  expectGuarantee(image, 4, {.inside = [&](const Vec3<double>& p) {
                    const auto r = p - Vec3<double>(this->oblique_.offset);
                    const Vec3<double> q{dot(cross(b, c), r) / det, dot(cross(c, a), r) / det,
                                         dot(cross(a, b), r) / det};
                    return this->ring_.signedDistance(Vec3<T>(q)) < 0;
                  }});
  expectGuarantee(transformed(this->box_ | this->ring_, stretch<T>(T(0.5), -2, 1, {1, 0, 0})), 4);
  expectGuarantee(rotated(transformed(this->box_ - this->ring_, this->oblique_), 40, {1, 2, 3}), 4);
  expectGuarantee(transformed(transformed(this->box_, this->oblique_), stretch<T>(3, 1, 1)), 8);
}

TYPED_TEST(AffineTest, CrossingsHaveTheNormalsOfTheImage) {
  using T = TypeParam;
  const auto image = transformed(this->ring_, this->oblique_);
  RandomPoints<T> points(3);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    image.crossings({points.next(), points.next()}, [&](const Crossing<T>& c) {
      const auto normal = image.normal(c.point, sizeof(T) == 4 ? T(1e-2) : T(1e-5));
      EXPECT_NEAR(dot(c.normal, normal), T(1), T(2e-3)) << c.point;
      return ++found > 0;
    });
  }
  EXPECT_GT(found, 50);
}

TYPED_TEST(AffineTest, OfUnequalStretchRoundsAsItStates) {
  const auto make = [](auto scalar) {
    using S = decltype(scalar);
    const AffineMap<S> map{{{{S(0.001), S(0.5), 0}, {0, 3, S(0.1)}, {S(-0.2), 0, 20}}}, {1, 2, 3}};
    return transformed(Sphere<S>({1, 2, 3}, 1), map);
  };
  expectRounding(make(float{}), make(double{}), 40);
}

TYPED_TEST(AffineTest, ClassifiesBoxesOfADiagonalMapAsTheOperandDoes) {
  using T = TypeParam;
  const auto flat = transformed(this->box_, stretch<T>(4, 1, T(0.5)));
  // Value and Lipschitz constant alone would not decide these: they are six times as long as deep.
  const T y = T(0.25);
  EXPECT_EQ(flat.classify({{T(-1.5), -y, -y / 2}, {T(1.5), y, y / 2}}), BoxClass::Inside);
  EXPECT_EQ(flat.classify({{T(-1.5), -y, T(0.9)}, {T(1.5), y, T(1.1)}}), BoxClass::Outside);
  EXPECT_EQ(flat.classify({{-5, T(-0.5), T(0.25)}, {5, T(0.5), 1}}), BoxClass::Cut);
}

TYPED_TEST(AffineTest, ChainsAskTheOperandOnceForAClass) {
  using T = TypeParam;
  std::size_t calls = 0;
  auto chain = countedBall<T>(calls);
  for (int n = 0; n < 12; ++n) {
    AffineMap<T> map;
    map.columns = {Vec3<T>{n % 2 == 0 ? T(2) : T(0.5), 0, 0}, {0, 1, 0}, {0, 0, 1}};
    chain = transformed(chain, map);
  }
  static_cast<void>(chain.classify({{T(0.99), T(-0.5), T(-0.5)}, {T(1.2), T(0.5), T(0.5)}}));
  EXPECT_LT(calls, 1000U);
}

TYPED_TEST(AffineTest, RefusesSingularMaps) {
  using T = TypeParam;
  const T tiny = std::numeric_limits<T>::epsilon();
  EXPECT_THROW(static_cast<void>(transformed(this->box_, stretch<T>(1, 1, 0))), Error);
  EXPECT_THROW(static_cast<void>(transformed(this->box_, stretch<T>(1, 1, tiny))), Error);
  EXPECT_THROW(
      static_cast<void>(transformed(this->box_, {{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, {}})), Error);
  EXPECT_THROW(static_cast<void>(
                   transformed(this->box_, stretch<T>(1, 1, std::numeric_limits<T>::infinity()))),
               Error);
  EXPECT_NO_THROW(static_cast<void>(transformed(this->box_, stretch<T>(1, 1, T(0.01)))));
}

}  // namespace
}  // namespace cutwater::test
