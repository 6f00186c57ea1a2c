#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Forwarding.hpp>
#include <Cutwater/Render/Detail/SphereTracer.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <numbers>
#include <optional>

#include "Looks.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SphereTracerTest : public ::testing::Test {};
TYPED_TEST_SUITE(SphereTracerTest, Precisions);

/// Where a ray enters the unit ball about the origin; and by how much it misses or hits it.
struct BallHit {
  explicit BallHit(const detail::Ray& ray)
      : middle(-dot(ray.origin, ray.direction)), gap(length(ray.at(middle)) - 1) {}

  [[nodiscard]] double along() const { return middle - std::sqrt(1 - (1 + gap) * (1 + gap)); }

  double middle;
  double gap;  // negative: it hits
};

/// Hits to a tenth of a pixel across, depths to a tenth of a pixel where the ball faces the viewer.
void expectBall(const Look& look, std::span<const detail::SurfaceSample> samples,
                double straight = 0.9999) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto ray = look.ray(i);
    const BallHit ball(ray);
    const double pixel = look.camera.pixelSize(ball.middle);
    if (std::abs(ball.gap) < 0.1 * pixel) continue;
    ASSERT_EQ(samples[i].isHit(), ball.gap < 0) << i;
    if (ball.gap > -3 * pixel) continue;
    ASSERT_NEAR(static_cast<double>(samples[i].along), ball.along(), 0.02 * pixel) << i;
    const auto normal = ray.at(ball.along());
    ASSERT_GT(dot(Vec3<double>(samples[i].normal), normal), straight) << i;
  }
}

TYPED_TEST(SphereTracerTest, FindsABallWhereItIs) {
  const Sphere<TypeParam> ball({0, 0, 0}, 1);
  for (const auto* name : {"+x", "-y", "+z", "iso"}) {
    for (const double fieldOfView : {0.0, 40.0}) {
      const Look look(View::named(name), fieldOfView);
      expectBall(look, look.at(ball));
    }
  }
}

TYPED_TEST(SphereTracerTest, DividesByTheLipschitzConstant) {
  using T = TypeParam;
  const auto value = [](const Vec3<T>& p) {
    return length(p) * (length(p) - 1) * T(4);  // up to 4 (2 |p| - 1) as steep
  };
  const FunctionSDF ball(value, Guarantee<T>{.lipschitz = T(16), .continuous = true});
  const Look look(View::named("iso"));
  expectBall(look, look.at(ball));
}

TYPED_TEST(SphereTracerTest, AsksForCrossingsWhereOnlySignsAreKnown) {
  using T = TypeParam;
  const auto value = [](const Vec3<T>& p) { return lengthSquared(p) < 1 ? T(-9) : T(9); };
  const FunctionSDF ball(value, Guarantee<T>{});
  const Look look(View::named("+x"));
  const auto samples = look.at(ball);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const BallHit hit(look.ray(i));
    // What a 4096th of the way misses.
    if (std::abs(hit.gap) < 1e-5) continue;
    ASSERT_EQ(samples[i].isHit(), hit.gap < 0) << i;
  }
}

/// Rays that go on by equal steps and look at signs.
template <typename T>
std::size_t hitsByMarching(const Look& look, const SignedDistanceFunction<T>& solid, double step) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < Look::kSide * Look::kSide; ++i) {
    const auto ray = look.ray(i);
    bool found = false;
    for (int n = 0; n * step < 3 && !found; ++n) {
      const double along = n * step - 1.5;
      found = solid.signedDistance(Vec3<T>(ray.at(along))) < 0;
    }
    hits += found ? 1 : 0;
  }
  return hits;
}

TYPED_TEST(SphereTracerTest, NeverStepsThroughWhatIsThin) {
  using T = TypeParam;
  constexpr T kHalf = T(2e-6);
  const Solid<T> plate =
      Cuboid<T>({T(-0.5), T(-0.5), T(0.1) - kHalf}, {T(0.5), T(0.5), T(0.1) + kHalf});
  // The same as the common part of two that are thick: values are mere bounds.
  const Solid<T> common = Cuboid<T>({T(-0.5), T(-0.5), T(-1)}, {T(0.5), T(0.5), T(0.1) + kHalf}) &
                          Cuboid<T>({T(-0.5), T(-0.5), T(0.1) - kHalf}, {T(0.5), T(0.5), T(1)});
  ASSERT_EQ(common.guarantee().outside, Quality::LowerBound);
  const Look look(View::from({0.3, -0.2, 1}));
  // Its area as the viewer sees it, in pixels.
  const double area = look.camera.view().back.z / (Look::kPixel * Look::kPixel) *
                      std::pow(Look::kHalf / (0.5 * Look::kSide * look.camera.pixelSize(0)), 2);
  for (const auto& solid : {plate, common}) {
    EXPECT_NEAR(static_cast<double>(hits(look.at(solid))), area, 0.02 * area);
    EXPECT_LT(static_cast<double>(hitsByMarching(look, solid, look.camera.pixelSize(0) / 4)),
              0.02 * area);
  }
}

TYPED_TEST(SphereTracerTest, RaysAlongAFaceEndSomewhere) {
  using T = TypeParam;
  // Sides between two columns of pixels, a fifth of a pixel from one of them.
  for (const double fraction : {0.2, 0.8}) {
    const double side = (static_cast<int>(0.7 / Look::kPixel) + 0.5 + fraction) * Look::kPixel;
    const T s = static_cast<T>(side);
    const Cuboid<T> box({-s, -s, T(-1.1)}, {s, s, T(1.1)});
    const Look look(View::named("+z"));
    const auto samples = look.at(box);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto p = look.ray(i).origin;
      ASSERT_EQ(samples[i].isHit(), std::max(std::abs(p.x), std::abs(p.y)) < side) << i;
    }
  }
}

TYPED_TEST(SphereTracerTest, TellsWhatPassesBetweenRays) {
  using T = TypeParam;
  const Look look(View::named("+z"));
  // A wire of no width along y, 0.3 and 0.7 pixels from two columns of rays.
  const double x = 10.2 * Look::kPixel;
  constexpr T kHalf = T(1e-5);
  const T at = static_cast<T>(x);
  const Cuboid<T> wire({at - kHalf, -1, -kHalf}, {at + kHalf, 1, kHalf});
  const auto samples = look.at(wire);
  EXPECT_EQ(hits(samples), 0U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto p = look.ray(i).origin;
    if (std::abs(p.y) > 1) continue;
    const double gap = std::abs(p.x - x) / Look::kPixel;
    if (gap < 0.71) {
      EXPECT_EQ(samples[i].passed, 0U) << i;
    }
    if (gap > 0.84) {
      EXPECT_EQ(samples[i].passed, kNone) << i;
    }
  }
}

TYPED_TEST(SphereTracerTest, CutsShowFaces) {
  using T = TypeParam;
  const Solid<T> hollow = Solid<T>(Sphere<T>({0, 0, 0}, 1)) - Sphere<T>({0, 0, 0}, T(0.5));
  const std::array cuts{CutPlane::across(2, 0.25)};
  const Look look(View::named("+z"));
  const auto samples = look.at(hollow, cuts);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto ray = look.ray(i);
    const double r = std::hypot(ray.origin.x, ray.origin.y);
    const double outer = std::sqrt(1 - 0.0625);
    const double inner = std::sqrt(0.25 - 0.0625);
    const double margin = 0.1 * Look::kPixel;
    if (r < inner - margin) {
      ASSERT_EQ(samples[i].surface, 1U) << i;  // the bottom of the hollow
      ASSERT_NEAR(ray.at(static_cast<double>(samples[i].along)).z, -std::sqrt(0.25 - r * r),
                  0.05 * Look::kPixel);
    } else if (r > inner + margin && r < outer - margin) {
      ASSERT_TRUE(samples[i].isCut()) << i;
      ASSERT_NEAR(ray.at(static_cast<double>(samples[i].along)).z, 0.25, 1e-6);
    } else if (r > outer + margin && r < 1 - margin) {
      ASSERT_EQ(samples[i].surface, 0U) << i;  // below the plane, around
    } else if (r > 1 + margin) {
      ASSERT_FALSE(samples[i].isHit()) << i;
    }
  }
}

/// A square across z = 0 without thickness; `back`: with another on it that looks down.
PolygonSoup square(bool back) {
  PolygonSoup soup;
  soup.points = {{-0.8, -0.8, 0}, {0.8, -0.8, 0}, {0.8, 0.8, 0}, {-0.8, 0.8, 0}};
  soup.patchNames = {"up", "down"};
  soup.addPolygon(std::array{0U, 1U, 2U, 3U}, 0);
  if (back) soup.addPolygon(std::array{0U, 3U, 2U, 1U}, 1);
  return soup;
}

TYPED_TEST(SphereTracerTest, ShowsSheetsIfAsked) {
  using T = TypeParam;
  const Look look(View::named("iso"));
  const MeshSDF<T> sheet(square(false));
  EXPECT_EQ(hits(look.at(sheet)), 0U);
  const auto seen = hits(look.at(sheet, {}, {.sheets = true, .occlusionRadius = 0}));
  const double pixel = look.camera.pixelSize(0);
  EXPECT_NEAR(static_cast<double>(seen), 2.56 * std::sqrt(1 / 3.0) / (pixel * pixel), 60);
}

TYPED_TEST(SphereTracerTest, OfSheetsOnEachOtherTheOneThatLooksHereIsSeen) {
  using T = TypeParam;
  auto slanted = square(true);
  for (auto& p : slanted.points) p.z = 0.03 * p.x + 0.07 * p.y;
  // They are closed together, and a solid without thickness.
  for (const auto& soup : {square(true), slanted}) {
    const MeshSDF<T> both(soup);
    for (const bool sheets : {true, false}) {
      for (const double z : {1.0, -1.0}) {
        const Look look(View::from({0.4, -0.7, z}));
        std::size_t seen = 0;
        for (const auto& sample : look.at(both, {}, {.sheets = sheets, .occlusionRadius = 0})) {
          if (!sample.isHit()) continue;
          ++seen;
          ASSERT_EQ(sample.surface, z > 0 ? 0U : 1U) << sheets;
        }
        EXPECT_GT(seen, 1000U);
      }
    }
  }
}

TYPED_TEST(SphereTracerTest, FacetsShowWhatStepsWouldFind) {
  const MeshSDF<TypeParam> ball(tessellation::icosphere(1, 4));
  const auto facets = detail::FacetRays::of(ball, Look::cube(), 1);
  ASSERT_TRUE(facets.has_value());
  const std::array cuts{CutPlane::across(0, 0.3), CutPlane::across(2, 0.4)};
  for (const double fieldOfView : {0.0, 40.0}) {
    for (const auto& some : {std::span<const CutPlane>(), std::span<const CutPlane>(cuts)}) {
      const Look look(View::named("iso"), fieldOfView);
      const auto stepped = look.at(ball, some);
      const auto met = look.at(ball, some, {.facets = &*facets});
      std::size_t others = 0;
      for (std::size_t i = 0; i < met.size(); ++i) {
        const bool isSame =
            met[i].surface == stepped[i].surface &&
            (!met[i].isHit() || std::abs(met[i].along - stepped[i].along) < 0.05 * Look::kPixel);
        others += isSame ? 0 : 1;  // beside silhouettes, where a ray that passes counts as a hit
      }
      EXPECT_LT(others, 40U);
      EXPECT_GT(hits(met), 1000U);
    }
  }
}

TYPED_TEST(SphereTracerTest, DraftsShowPlatesWithoutThicknessHoweverSlanted) {
  using T = TypeParam;
  constexpr T kHalf = T(2e-6);
  const Solid<T> plate = Cuboid<T>({T(-0.9), T(-0.9), -kHalf}, {T(0.9), T(0.9), kHalf});
  // The same as the common part of two that are thick: values are mere bounds.
  const Solid<T> common = Cuboid<T>({T(-0.9), T(-0.9), T(-1)}, {T(0.9), T(0.9), kHalf}) &
                          Cuboid<T>({T(-0.9), T(-0.9), -kHalf}, {T(0.9), T(0.9), T(1)});
  for (const double slope : {2.0, 1.0, 0.5, 0.3, 0.2, 0.1}) {
    const Look look(View::from({1, -0.2, slope}));
    const double pixel = look.camera.pixelSize(0);
    for (const auto& solid : {plate, common}) {
      const auto samples = look.at(solid, {}, {.isDraft = true});
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto ray = look.ray(i);
        const double along = -ray.origin.z / ray.direction.z;
        const auto p = ray.at(along);
        const double inside = 0.9 - std::max(std::abs(p.x), std::abs(p.y));
        if (inside < pixel / slope) continue;
        ASSERT_TRUE(samples[i].isHit()) << slope << ' ' << p.x << ' ' << p.y;
        ASSERT_NEAR(samples[i].along, along, 0.1 * pixel / slope) << p.x << ' ' << p.y;
      }
    }
  }
}

/// Counts the values that are asked for.
template <std::floating_point T>
class Counted final : public Forwarding<T, Counted<T>> {
 public:
  explicit Counted(Solid<T> solid) : Forwarding<T, Counted<T>>(std::move(solid)) {}

  mutable std::size_t values = 0;

 private:
  friend Forwarding<T, Counted<T>>;

  T value(T value) const {
    ++values;
    return value;
  }
  Guarantee<T> localGuarantee() const override { return this->operand().guarantee(); }
  Box<T> localBoundingBox() const override { return this->operand().boundingBox(); }
};

TYPED_TEST(SphereTracerTest, DraftsTakeFewStepsAlongWhatIsCurved) {
  using T = TypeParam;
  const Counted<T> ball(Sphere<T>({0, 0, 0}, 1));
  // Rays that pass the silhouette, on either side of it.
  const Look look(View::named("+z"));
  const detail::KeptRegion region(Look::cube(), {}, false);
  const auto valuesOf = [&](bool isDraft) {
    ball.values = 0;
    const detail::SphereTracer<T> tracer(ball, region, look.camera, {.isDraft = isDraft});
    for (const double gap : {-0.7, -0.3, -0.1, 0.05, 0.1, 0.2, 0.4}) {
      std::vector<detail::SurfaceSample> sample(1);
      const double x = 0.5 * Look::kSide + 1 / Look::kPixel + gap;
      tracer.trace(std::array{detail::PicturePoint{x, 0.5 * Look::kSide}}, {}, sample);
      EXPECT_EQ(sample.front().isHit(), gap < 0) << gap;
    }
    return ball.values;
  };
  EXPECT_LT(valuesOf(true), 0.6 * static_cast<double>(valuesOf(false)));
}

TYPED_TEST(SphereTracerTest, DraftsShowABallWhereItIs) {
  const Sphere<TypeParam> ball({0, 0, 0}, 1);
  for (const double fieldOfView : {0.0, 40.0}) {
    const Look look(View::named("iso"), fieldOfView);
    expectBall(look, look.at(ball, {}, {.isDraft = true}), 0.9995);
  }
}

TYPED_TEST(SphereTracerTest, WhatIsCutOffKeepsNoLightAway) {
  using T = TypeParam;
  // Of a beam within a block only the end is left; the block's sides bound the values beside it.
  const Solid<T> rest = Cuboid<T>({T(-0.2), T(-0.2), T(0.15)}, {T(0.2), T(0.2), T(0.5)}) &
                        Cuboid<T>({-1, -1, T(0.05)}, {T(-0.19), 1, 1});
  const Solid<T> scene = Cuboid<T>({-1, -1, T(-0.2)}, {1, 1, 0}) | rest;
  const Look look(View::named("+z"));
  const auto samples = look.at(scene, {}, {.occlusionRadius = 0.3});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto p = look.ray(i).origin;
    if (std::abs(p.y - 0.9) < Look::kPixel && std::abs(p.x + 0.6) < 0.2) {
      ASSERT_GT(samples[i].open, 0.95F) << p.x;
    }
  }
}

TYPED_TEST(SphereTracerTest, CornersGetLessLight) {
  using T = TypeParam;
  const Solid<T> floor = Cuboid<T>({-1, -1, T(-0.2)}, {1, 1, 0});
  const Solid<T> room = floor | Cuboid<T>({-1, -1, 0}, {T(-0.8), 1, 1});
  const detail::TraceOptions options{.sheets = false, .occlusionRadius = 0.3};
  const Look look(View::named("+z"));
  const auto openAt = [&](const auto& samples, double x) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto p = look.ray(i).origin;
      if (std::abs(p.y) < Look::kPixel && std::abs(p.x - x) < Look::kPixel) return samples[i].open;
    }
    return -1.0F;
  };
  const auto samples = look.at(room, {}, options);
  EXPECT_GT(openAt(samples, 0.2), 0.99F);
  EXPECT_LT(openAt(samples, -0.75), 0.6F);
  EXPECT_LT(openAt(samples, -0.75), openAt(samples, -0.65));
  // A wall that is cut away keeps no light away.
  const std::array cuts{CutPlane::across(2, 0.01)};
  EXPECT_GT(openAt(look.at(room, cuts, options), -0.75), 0.9F);
}

}  // namespace
}  // namespace cutwater::test
