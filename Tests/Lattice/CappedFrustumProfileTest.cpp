#include <Cutwater/Lattice/Detail/CappedBeam.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <cmath>
#include <numbers>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// A frustum along z from the origin, by definition: what is in it, and points of its boundary.
struct Frustum {
  double height, radiusA, radiusB;
  std::array<BeamCap, 2> caps;

  [[nodiscard]] bool isInside(double y, double x) const {
    const auto inBall = [&](double from, double radius) { return std::hypot(y, from) < radius; };
    if (caps[0] == BeamCap::Sphere && inBall(x, radiusA)) return true;
    if (caps[1] == BeamCap::Sphere && inBall(x - height, radiusB)) return true;
    if (x < 0) return caps[0] == BeamCap::Hemisphere && inBall(x, radiusA);
    if (x > height) return caps[1] == BeamCap::Hemisphere && inBall(x - height, radiusB);
    return y < radiusA + (radiusB - radiusA) * x / height;
  }
  /// Calls visit(y, x) for points on all sides that may be boundary.
  template <typename Visit>
  void forSides(int count, Visit visit) const {
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      visit(radiusA + t * (radiusB - radiusA), t * height);
      visit(t * radiusA, 0.0);
      visit(t * radiusB, height);
      const double angle = t * std::numbers::pi;
      visit(radiusA * std::sin(angle), radiusA * std::cos(angle));
      visit(radiusB * std::sin(angle), height + radiusB * std::cos(angle));
    }
  }
  [[nodiscard]] bool isBoundary(double y, double x) const {
    constexpr double kBeside = 1e-7;
    bool inside = false;
    bool outside = false;
    for (int i = 0; i < 16; ++i) {
      const double angle = i * std::numbers::pi / 8 + 0.1;
      const bool is =
          isInside(std::abs(y + kBeside * std::cos(angle)), x + kBeside * std::sin(angle));
      (is ? inside : outside) = true;
    }
    return inside && outside;
  }
};

template <typename T>
class CappedFrustumProfileTest : public ::testing::Test {
 protected:
  template <typename Check>
  static void forKinds(Check check) {
    for (const auto& [height, a, b] : {std::array{2.0, 0.5, 0.5},
                                       {1.0, 0.75, 0.25},
                                       {1.0, 0.0, 0.5},
                                       {0.25, 0.5, 1.0},
                                       {0.125, 1.0, 0.25}}) {
      for (const auto capA : {BeamCap::Butt, BeamCap::Hemisphere, BeamCap::Sphere}) {
        for (const auto capB : {BeamCap::Butt, BeamCap::Hemisphere, BeamCap::Sphere})
          check(Frustum{height, a, b, {capA, capB}});
      }
    }
  }
  static CappedBeam<T> beam(const Frustum& f) {
    return {{0, 0, 0}, {0, 0, T(f.height)}, T(f.radiusA), T(f.radiusB), f.caps};
  }
};
TYPED_TEST_SUITE(CappedFrustumProfileTest, Precisions);

TYPED_TEST(CappedFrustumProfileTest, IsTheDistanceToSampledSides) {
  using T = TypeParam;
  this->forKinds([&](const Frustum& f) {
    constexpr int kSides = 2000;
    std::vector<std::array<double, 2>> boundary;
    f.forSides(kSides, [&](double y, double x) {
      if (f.isBoundary(y, x)) boundary.push_back({y, x});
    });
    const auto beam = this->beam(f);
    const bool hasBalls = f.caps[0] == BeamCap::Sphere || f.caps[1] == BeamCap::Sphere;
    RandomPoints<T> random(T(1.5), /*seed=*/9);
    for (int i = 0; i < scaled(60); ++i) {
      const auto p = random.next();
      const double y = std::abs(double{p.x});
      const double x = double{p.z};
      double nearest = 9;
      for (const auto& q : boundary) nearest = std::min(nearest, std::hypot(y - q[0], x - q[1]));
      const bool inside = f.isInside(y, x);
      const double value = beam.distance({static_cast<T>(y), 0, p.z});
      const double spacing = 4.0 / kSides;
      if (inside && hasBalls) {
        EXPECT_LE(value, 0);
        EXPECT_GE(value, -nearest - 1e-6);
      } else {
        EXPECT_NEAR(value, inside ? -nearest : nearest, spacing) << y << ' ' << x;
      }
      // The gradient leads to the surface.
      const Vec3<T> at{static_cast<T>(y), 0, p.z};
      const auto g = beam.gradient(at);
      EXPECT_NEAR(length(g), 1, 1e-5);
      if (!inside || !hasBalls) {
        EXPECT_NEAR(beam.distance(at - static_cast<T>(value) * g), 0, tolerance<T>(2, 32));
      }
    }
  });
}

TYPED_TEST(CappedFrustumProfileTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto at = [](const CappedBeam<T>& beam, T y, T x) { return beam.distance({0, y, x}); };
  const CappedBeam<T> flat({0, 0, 0}, {0, 0, 4}, 1, 1, {BeamCap::Butt, BeamCap::Butt});
  const CappedBeam<T> half({0, 0, 0}, {0, 0, 4}, 1, 1, {BeamCap::Hemisphere, BeamCap::Butt});
  const CappedBeam<T> round({0, 0, 0}, {0, 0, 4}, 1, 1, {BeamCap::Sphere, BeamCap::Hemisphere});
  EXPECT_EQ(at(flat, 0, -3), T(3));
  EXPECT_EQ(at(half, 0, -3), T(2));
  EXPECT_EQ(at(half, 0, 6), T(2));
  EXPECT_EQ(at(round, 0, 6), T(1));
  EXPECT_EQ(at(flat, 0, 0), T(0));
  EXPECT_EQ(at(half, 0, 0), T(-1));  // the disc between the two is no surface
  EXPECT_EQ(at(round, 0, 4), T(-1));
  EXPECT_EQ(at(half, 0, T(3.75)), T(-0.25));
  // Of a beam shorter than its radius, a whole ball comes out at the other end.
  const CappedBeam<T> disc({0, 0, 0}, {0, 0, T(0.25)}, 1, 1, {BeamCap::Sphere, BeamCap::Butt});
  EXPECT_EQ(at(disc, 0, 2), T(1));
  EXPECT_EQ(disc.boundingBox().contains({0, 0, 1}), true);
}

TYPED_TEST(CappedFrustumProfileTest, BoxesHoldTheirBeams) {
  using T = TypeParam;
  RandomPoints<T> random(1, /*seed=*/4);
  this->forKinds([&](const Frustum& f) {
    const auto a = random.next();
    const auto b = random.next();
    const CappedBeam<T> beam(a, b, T(f.radiusA), T(f.radiusB), f.caps);
    const auto box = beam.boundingBox();
    for (int i = 0; i < 3000; ++i) {
      const auto p = T(2) * random.next();
      EXPECT_TRUE(beam.distance(p) >= 0 || box.contains(p)) << p;
    }
  });
}

}  // namespace
}  // namespace cutwater::test
