#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <array>

#include "Support/Float128.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class EllipsoidTest : public ::testing::Test {};
TYPED_TEST_SUITE(EllipsoidTest, Precisions);

/// By bisection, in quadruple precision, about the origin.
class Bisected {
 public:
  explicit Bisected(const Vec3<double>& semiAxes) : e_{semiAxes.x, semiAxes.y, semiAxes.z} {
    least_ = std::min({e_[0], e_[1], e_[2]});
  }

  [[nodiscard]] double distance(const Vec3<double>& p) const {
    const std::array<Float128, 3> y{p.x, p.y, p.z};
    // Of t in sum (e y / (e^2 - least^2 + t))^2 = 1: near 0 where the point is close to the plane
    // of the long axes, and precise there.
    Float128 low = 0;
    Float128 high = 0;
    for (std::size_t i = 0; i < 3; ++i) high += e_[i] * e_[i] * y[i] * y[i];
    high = squareRoot(high) + least_ * least_ + 1;
    for (int step = 0; step < 3000; ++step) {
      const Float128 middle = (low + high) / 2;
      if (middle == low || middle == high) break;
      (sum(y, middle) > 1 ? low : high) = middle;
    }
    const Float128 s = high - least_ * least_;
    // What the sum lacks of 1 belongs to the shortest axis, on which the point is not.
    const Float128 lacking = s > 0 ? Float128(0) : 1 - sum(y, high);
    Float128 squared = lacking > 0 && isInPlane(y) ? lacking * least_ * least_ : Float128(0);
    for (std::size_t i = 0; i < 3; ++i) {
      if (y[i] == 0) continue;
      const Float128 gap = y[i] * s / pole(i, high);
      squared += gap * gap;
    }
    const Float128 distance = squareRoot(squared);
    return static_cast<double>(s < 0 ? -distance : distance);
  }

 private:
  [[nodiscard]] bool isInPlane(const std::array<Float128, 3>& y) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (e_[i] == least_ && y[i] != 0) return false;
    }
    return true;
  }
  [[nodiscard]] Float128 pole(std::size_t i, const Float128& t) const {
    return (e_[i] - least_) * (e_[i] + least_) + t;
  }
  [[nodiscard]] Float128 sum(const std::array<Float128, 3>& y, const Float128& t) const {
    Float128 total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (y[i] == 0) continue;
      const Float128 w = e_[i] * y[i] / pole(i, t);
      total += w * w;
    }
    return total;
  }

  std::array<Float128, 3> e_;
  Float128 least_;
};

TYPED_TEST(EllipsoidTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Ellipsoid<T> solid({1, 0, 0}, {4, 1, 2});
  EXPECT_EQ(solid.signedDistance({7, 0, 0}), T(2));
  EXPECT_EQ(solid.signedDistance({1, -4, 0}), T(3));
  EXPECT_EQ(solid.signedDistance({1, 0, 2}), T(0));
  EXPECT_EQ(solid.signedDistance({1, 0, 0}), T(-1));
  EXPECT_EQ(solid.signedDistance({1, T(0.25), 0}), T(-0.75));
  // On the long axis, between the two centres of curvature of its ends (at 4 - 1/4 from the
  // centre): q_x = 16/15 x, and the rest by the surface's equation.
  for (const T x : {T(1.5), T(3), T(3.625), T(3.734375), T(3.75)}) {
    const T q = T(16) / 15 * x;
    const T height = std::sqrt(std::max(1 - q * q / 16, T(0)));
    EXPECT_NEAR(solid.signedDistance({1 + x, 0, 0}), -std::hypot(q - x, height), tolerance<T>(5));
  }
  EXPECT_NEAR(solid.signedDistance({1 + T(3.875), 0, 0}), T(-0.125), tolerance<T>(5));
  EXPECT_EQ(solid.gradient({-5, 0, 0}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(solid.gradient({1, -1, 0}), (Vec3<T>{0, -1, 0}));
  EXPECT_EQ(solid.gradient({2, 0, T(0.25)}), Vec3<T>{});  // both sides are equally near
}

TYPED_TEST(EllipsoidTest, IsASphereIfItsAxesAreEqual) {
  using T = TypeParam;
  const T radius = T(0.7);
  const Ellipsoid<T> solid({0, 0, 0}, {radius, radius, radius});
  const Sphere<T> sphere({0, 0, 0}, radius);
  RandomPoints<T> points(2);
  for (int i = 0; i < 1000; ++i) {
    auto p = points.next();
    if (i % 3 == 0) p[i / 3 % 3] = 0;
    EXPECT_NEAR(solid.signedDistance(p), sphere.signedDistance(p), tolerance<T>(2, 4)) << p;
    EXPECT_LT(length(solid.gradient(p) - sphere.gradient(p)), tolerance<T>(1, 8)) << p;
  }
  EXPECT_EQ(solid.signedDistance({0, 0, 0}), -radius);
}

/// Points around the surface, on axes, in planes of symmetry and close to them, and far away.
template <typename T>
Vec3<T> nastyPoint(RandomPoints<double>& random, const Vec3<T>& semiAxes, int i) {
  auto p = random.next();
  const double power = random.next().x;
  if (i % 4 == 1) p[i / 4 % 3] = 0;
  if (i % 8 == 2) p[i / 8 % 3] = p[(i / 8 + 1) % 3] = 0;
  if (i % 16 == 3) p[i / 16 % 3] *= std::pow(10, 10 * (power - 1));
  if (i % 3 == 0) return Vec3<T>(std::pow(10, 3 * power) * p);
  if (i % 3 == 1) p = (1 + std::pow(10, 4 * (power - 1))) * normalized(p);
  for (int axis = 0; axis < 3; ++axis) p[axis] *= double{semiAxes[axis]};
  return Vec3<T>(p);
}

TYPED_TEST(EllipsoidTest, AgreesWithBisectionInQuadruplePrecision) {
  using T = TypeParam;
  RandomPoints<double> random(1);
  const int solids = scaled(40);
  for (int k = 0; k < solids; ++k) {
    const auto powers = random.next();
    Vec3<T> semiAxes;
    for (int axis = 0; axis < 3; ++axis) {
      semiAxes[axis] = static_cast<T>(std::pow(10.0, (k % 2 == 0 ? 1.0 : 2.99) * powers[axis]));
    }
    if (k % 3 == 0) semiAxes[k / 3 % 3] = semiAxes[(k / 3 + 1) % 3];
    const Ellipsoid<T> solid({0, 0, 0}, semiAxes);
    const Bisected bisected{Vec3<double>(semiAxes)};
    for (int i = 0; i < 96; ++i) {
      const auto p = nastyPoint(random, semiAxes, i);
      const double error = double{solid.signedDistance(p)} - bisected.distance(Vec3<double>(p));
      const T size = length(p) + maxComponent(semiAxes);
      // What the class states; the guarantee allows for 8.
      EXPECT_LE(std::abs(error), double{tolerance<T>(size, 3)}) << semiAxes << " at " << p;
    }
  }
}

TYPED_TEST(EllipsoidTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Ellipsoid<T>({0, 0, 0}, {1, 0, 1})), Error);
  EXPECT_THROW((Ellipsoid<T>({0, 0, 0}, {1, 1, -1})), Error);
  EXPECT_THROW((Ellipsoid<T>({0, 0, 0}, {1, inf, 1})), Error);
  EXPECT_THROW((Ellipsoid<T>({0, 0, 0}, {nan, 1, 1})), Error);
  EXPECT_THROW((Ellipsoid<T>({0, nan, 0}, {1, 1, 1})), Error);
  EXPECT_THROW((Ellipsoid<T>({0, 0, 0}, {1, T(2e6), 1})), Error);
}

TYPED_TEST(EllipsoidTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      Ellipsoid<T>({T(0.25), 0, T(-0.125)}, {1, T(0.5), T(0.75)}), 2,
      {.inside = [](const Vec3<double>& p) {
        return lengthSquared(Vec3<double>{p.x - 0.25, p.y / 0.5, (p.z + 0.125) / 0.75}) < 1;
      }});
  expectGuarantee(Ellipsoid<T>({0, 0, 0}, {1, T(0.125), 1}), 2, {.covering = 4});  // a lens
  expectGuarantee(Ellipsoid<T>({0, 0, 0}, {T(0.25), T(0.25), 1}), 2, {.covering = 4});
}

TEST(EllipsoidRounding, StaysWithinItsBound) {
  expectRounding(Ellipsoid<float>({0, 0, 0}, {1, 2, 3}), Ellipsoid<double>({0, 0, 0}, {1, 2, 3}),
                 4);
  expectRounding(Ellipsoid<float>({9, 8, 7}, {1, 0.001f, 3}),
                 Ellipsoid<double>({9, 8, 7}, {1, 0.001f, 3}), 4);
  expectRounding(Ellipsoid<float>({0, 0, 0}, {0.001f, 2, 0.001f}),
                 Ellipsoid<double>({0, 0, 0}, {0.001f, 2, 0.001f}), 4);
}

}  // namespace
}  // namespace cutwater::test
