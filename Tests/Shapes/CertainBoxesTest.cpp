#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <array>
#include <functional>
#include <random>
#include <vector>

#include "Support/Float128.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

// Classes of boxes against exact arithmetic. All coordinates are multiples of a power of two, so
// that squares and their sums are exact in quadruple precision.

namespace cutwater::test {
namespace {

using Real = Float128;

/// The magnitudes of coordinates between two ends.
struct Magnitudes {
  Real least;
  Real most;

  Magnitudes(Real lower, Real upper) {
    const Real a = lower < 0 ? -lower : lower;
    const Real b = upper < 0 ? -upper : upper;
    least = lower <= 0 && upper >= 0 ? Real(0) : a < b ? a : b;
    most = a < b ? b : a;
  }
};

int sign(Real a) {
  return a < 0 ? -1 : a > 0 ? 1 : 0;
}

/// From the signs of the least and the greatest value in the box.
BoxClass classOf(int least, int most) {
  return most < 0 ? BoxClass::Inside : least > 0 ? BoxClass::Outside : BoxClass::Cut;
}

/// The sign of (sqrt(y2) - major)^2 + z2 - r2, for distances y from the axis.
int ringSign(Real y2, Real major, Real z2, Real r2) {
  const Real rest = y2 + major * major + z2 - r2;
  const Real twice = 4 * major * major * y2;  // squared
  return rest < 0 ? -1 : sign(rest * rest - twice);
}

constexpr double kGrain = 0x1p-16;
double grained(double a) {
  return std::round(a / kGrain) * kGrain;
}

/// A solid, the class of a box by exact arithmetic, and a point on or near its surface.
template <std::floating_point T>
struct Case {
  const char* name;
  Solid<T> solid;
  std::function<BoxClass(const Box<T>&)> exactly;
  std::function<Vec3<double>(const Vec3<double>& direction)> surface;
};

template <std::floating_point T>
Case<T> ball() {
  const T r = T(grained(0.6));
  const Vec3<T> c{T(grained(0.013)), T(grained(-0.021)), T(grained(0.007))};
  return {"ball", Sphere<T>(c, r),
          [=](const Box<T>& box) {
            Real least = -Real(r) * r;
            Real most = least;
            for (int i = 0; i < 3; ++i) {
              const Magnitudes m(Real(box.lower[i]) - c[i], Real(box.upper[i]) - c[i]);
              least += m.least * m.least;
              most += m.most * m.most;
            }
            return classOf(sign(least), sign(most));
          },
          [=](const Vec3<double>& d) { return Vec3<double>(c) + double{r} * d; }};
}

template <std::floating_point T>
Case<T> ring() {
  const T major = T(grained(0.6));
  const T minor = T(grained(0.21));
  return {"ring", Torus<T>(major, minor),
          [=](const Box<T>& box) {
            const Magnitudes x(box.lower.x, box.upper.x);
            const Magnitudes y(box.lower.y, box.upper.y);
            const Magnitudes z(box.lower.z, box.upper.z);
            const Real near = x.least * x.least + y.least * y.least;
            const Real far = x.most * x.most + y.most * y.most;
            const Real ring = major;
            const Real r2 = Real(minor) * minor;
            const bool reachesCircle = near <= ring * ring && ring * ring <= far;
            const int least = reachesCircle ? sign(z.least * z.least - r2)
                                            : ringSign(near > ring * ring ? near : far, ring,
                                                       z.least * z.least, r2);
            return classOf(least, std::max(ringSign(near, ring, z.most * z.most, r2),
                                           ringSign(far, ring, z.most * z.most, r2)));
          },
          [=](const Vec3<double>& d) {
            const double toAxis = std::hypot(d.x, d.y);
            const double y = double{major} + double{minor} * toAxis;
            return Vec3<double>{y * d.x / toAxis, y * d.y / toAxis, double{minor} * d.z};
          }};
}

template <std::floating_point T>
Case<T> cylinder() {
  const T r = T(grained(0.4));
  const T low = T(-0.5);
  const T high = T(0.25);
  return {"cylinder", Cylinder<T>({0, 0, low}, {0, 0, high}, r),
          [=](const Box<T>& box) {
            const Magnitudes x(box.lower.x, box.upper.x);
            const Magnitudes y(box.lower.y, box.upper.y);
            const Real r2 = Real(r) * r;
            const auto& [lower, upper] = box;
            const int apart = lower.z > high || upper.z < low     ? 1
                              : lower.z == high || upper.z == low ? 0
                                                                  : -1;
            const int beyond = lower.z < low || upper.z > high     ? 1
                               : lower.z == low || upper.z == high ? 0
                                                                   : -1;
            return classOf(std::max(apart, sign(x.least * x.least + y.least * y.least - r2)),
                           std::max(beyond, sign(x.most * x.most + y.most * y.most - r2)));
          },
          [=](const Vec3<double>& d) {
            const double toAxis = std::hypot(d.x, d.y);
            return Vec3<double>{double{r} * d.x / toAxis, double{r} * d.y / toAxis,
                                d.z > 0.5    ? double{high}
                                : d.z < -0.5 ? double{low}
                                             : 0.5 * d.z};
          }};
}

template <std::floating_point T>
Case<T> cuboid() {
  const Box<T> solid{{T(-0.625), T(-0.4375), T(-0.5)}, {T(0.5), T(0.375), T(0.3125)}};
  return {"cuboid", Cuboid<T>(solid),
          [=](const Box<T>& box) {
            bool isWithin = true;
            for (int i = 0; i < 3; ++i) {
              isWithin &= box.lower[i] > solid.lower[i] && box.upper[i] < solid.upper[i];
            }
            return isWithin              ? BoxClass::Inside
                   : box.overlaps(solid) ? BoxClass::Cut
                                         : BoxClass::Outside;
          },
          [=](const Vec3<double>& d) {
            const double most = maxComponent(abs(d));
            auto p = Vec3<double>(solid.center()) + 0.7 * d;
            for (int i = 0; i < 3; ++i) {
              if (std::abs(d[i]) == most) {
                p[i] = static_cast<double>(d[i] < 0 ? solid.lower[i] : solid.upper[i]);
              }
            }
            return p;
          }};
}

template <typename T>
class CertainBoxesTest : public ::testing::Test {
 protected:
  static Vec3<T> grainedPoint(const Vec3<double>& p) {
    return {static_cast<T>(grained(p.x)), static_cast<T>(grained(p.y)),
            static_cast<T>(grained(p.z))};
  }
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }
  Vec3<double> direction() {
    while (true) {
      const Vec3<double> d{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (length(d) > 0.1 && length(d) < 1) return normalized(d);
    }
  }

  /// Boxes anywhere, boxes around surface points, and boxes with the middle of a face, or a corner,
  /// that far from one: from nothing to a tenth. Some have no thickness.
  Box<T> box(int i, const Vec3<double>& surface) {
    const double size = std::pow(10.0, uniform(-4, 0));
    Vec3<double> half{size * uniform(0, 1), size * uniform(0, 1), size * uniform(0, 1)};
    if (i % 7 == 3) half[i % 3] = 0;
    auto center = i % 4 == 0 ? direction() : surface;
    if (i % 4 >= 2) {
      const auto to = direction();
      center += std::pow(10.0, uniform(-6, -1)) * direction();
      const int face = i / 4 % 3;
      for (int axis = 0; axis < 3; ++axis) {
        if (i % 4 == 3 || axis == face) center[axis] += std::copysign(half[axis], to[axis]);
      }
    }
    return {grainedPoint(center - half), grainedPoint(center + half)};
  }

  void expectRight(const Case<T>& c, double mostUnknown) {
    const int all = scaled(20000);
    int unknown = 0;
    std::array<int, 3> count{};
    for (int i = 0; i < all; ++i) {
      const auto box = this->box(i, c.surface(direction()));
      const auto expected = c.exactly(box);
      const auto found = c.solid.classify(box);
      ++count[static_cast<std::size_t>(expected)];
      if (found == BoxClass::Unknown) {
        ++unknown;
      } else {
        ASSERT_EQ(static_cast<int>(found), static_cast<int>(expected))
            << c.name << " in " << box.lower << ' ' << box.upper;
      }
    }
    for (const int n : count) EXPECT_GT(n, all / 100) << c.name;
    EXPECT_LE(unknown, mostUnknown * all) << c.name;
  }

 private:
  std::mt19937_64 engine_{5};
};
TYPED_TEST_SUITE(CertainBoxesTest, Precisions);

TYPED_TEST(CertainBoxesTest, HaveTheClassesOfExactArithmetic) {
  using T = TypeParam;
  const double share = sizeof(T) == 4 ? 0.05 : 0.01;
  this->expectRight(ball<T>(), share);
  this->expectRight(ring<T>(), share);
  this->expectRight(cylinder<T>(), 0.1);  // many boxes touch its ends exactly
}

TYPED_TEST(CertainBoxesTest, OfACuboidAreAllKnown) {
  using T = TypeParam;
  auto c = cuboid<T>();
  this->expectRight(c, 0);
  // Also where it is moved by a number that rounds no coordinate.
  const Vec3<T> offset{T(0.25), T(-0.5), T(2)};
  c.solid.translate(offset);
  const auto exactly = c.exactly;
  c.exactly = [=](const Box<T>& box) { return exactly({box.lower - offset, box.upper - offset}); };
  const auto surface = c.surface;
  c.surface = [=](const Vec3<double>& d) { return surface(d) + Vec3<double>(offset); };
  this->expectRight(c, 0);
}

TYPED_TEST(CertainBoxesTest, OfGridPlanesAreCutOnBothSides) {
  using T = TypeParam;
  const Cuboid<T> cuboid({T(-0.5), T(-0.5), T(-0.5)}, {T(0.5), T(0.5), T(0.5)});
  const Plane<T> plane({0, 0, T(0.5)}, {0, 0, 1});
  std::array<std::array<int, 4>, 2> count{};
  for (int n = 0; n < 32 * 32 * 32; ++n) {
    const Vec3<T> lower{T(n % 32) / 16 - 1, T(n / 32 % 32) / 16 - 1, T(n / 1024) / 16 - 1};
    const Box<T> cell{lower, lower + Vec3<T>{T(1) / 16, T(1) / 16, T(1) / 16}};
    ++count[0][static_cast<std::size_t>(cuboid.classify(cell))];
    ++count[1][static_cast<std::size_t>(plane.classify(cell))];
  }
  // 18^3 cells touch the cuboid, of which 14^3 do not reach its faces.
  EXPECT_EQ(count[0], (std::array<int, 4>{2744, 26936, 5832 - 2744, 0}));
  EXPECT_EQ(count[1], (std::array<int, 4>{23 * 1024, 7 * 1024, 2 * 1024, 0}));
}

TEST(CertainBoxesTest, ABallThatEntersByLittleCuts) {
  const Sphere<double> ball({0.013, -0.021, 0.007}, 0.6);
  const Vec3<double> lower{32.0 / 32 - 1, 16.0 / 32 - 1, 45.0 / 32 - 1};
  EXPECT_EQ(ball.classify({lower, lower + Vec3<double>{1.0 / 32, 1.0 / 32, 1.0 / 32}}),
            BoxClass::Cut);
}

}  // namespace
}  // namespace cutwater::test
