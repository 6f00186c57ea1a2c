#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Forwarding.hpp>
#include <Cutwater/Render/Detail/SolidTracer.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <map>
#include <numbers>

#include "BarePicture.hpp"
#include "Colors.hpp"
#include "Looks.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using detail::SolidPart;
using detail::SurfaceSample;

/// The same solid with its expression hidden, so that it is one part.
template <std::floating_point T>
class Opaque final : public Forwarding<T, Opaque<T>> {
 public:
  explicit Opaque(Solid<T> solid) : Forwarding<T, Opaque<T>>(std::move(solid)) {}

 private:
  Guarantee<T> localGuarantee() const override { return this->operand().guarantee(); }
  Box<T> localBoundingBox() const override { return this->operand().boundingBox(); }
};

template <typename T>
class SolidTracerTest : public ::testing::Test {
 protected:
  static MeshSDF<T> box(const Vec3<double>& lower, const Vec3<double>& upper) {
    return MeshSDF<T>(triangulated(tessellation::box(lower, upper)));
  }
  /// A ball of triangles with two patches, one above the other.
  static MeshSDF<T> ball(double radius) {
    auto soup = tessellation::icosphere(radius, 4);
    soup.patchNames = {"lower", "upper"};
    soup.patches.assign(soup.polygonCount(), 0);
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      soup.patches[i] = soup.points[soup.polygon(i)[0]].z > 0.1 ? 1 : 0;
    }
    return MeshSDF<T>(soup);
  }
  /// A ball of triangles, a block and a lattice through one another, in nested unions that are
  /// named and placed; with five patches.
  static Solid<T> tangle() {
    const PeriodicLattice<T> lattice(
        UnitCell::bcc(), {.period = {T(0.5), T(0.5), T(0.5)}, .count = {3, 3, 2}}, T(0.06));
    const auto struts = translated(lattice, {T(-0.3), T(-0.9), T(-0.5)});
    const auto block = named(Cuboid<T>({T(-0.9), T(-0.3), T(-0.8)}, {0, T(0.4), T(0.2)}), "block");
    const auto inner = rotated(named(block | ball(0.6), "inner"), T(20), 2);
    return translated(struts | translated(inner, {T(0.1), 0, 0}), {0, T(0.1), 0}) |
           Sphere<T>({T(-0.5), T(-0.6), T(0.5)}, T(0.3));
  }

  static std::vector<SolidPart<T>> parts(const SignedDistanceFunction<T>& solid) {
    return detail::partsOf(solid, Look::cube(), /*sheets=*/false, 1);
  }
  static std::vector<SurfaceSample> byParts(const Look& look, const Solid<T>& solid,
                                            std::span<const CutPlane> cuts, bool isDraft) {
    const detail::KeptRegion region(Look::cube(), cuts, false);
    const auto found = parts(solid);
    const detail::SolidTracer<T> tracer(solid, found, region, look.camera, {.isDraft = isDraft});
    std::vector<SurfaceSample> samples(Look::kSide * Look::kSide);
    for (int y = 0; y < Look::kSide; ++y) {
      std::vector<detail::PicturePoint> row;
      for (int x = 0; x < Look::kSide; ++x) row.push_back(Look::middle(x, y));
      tracer.trace(row, {}, std::span(samples).subspan(row.size() * std::size_t(y), row.size()));
    }
    return samples;
  }
};
TYPED_TEST_SUITE(SolidTracerTest, Precisions);

TYPED_TEST(SolidTracerTest, PartsShowWhatStepsThroughTheUnionWouldFind) {
  const auto tangle = this->tangle();
  ASSERT_EQ(this->parts(tangle).size(), 2U);
  const std::array cuts{CutPlane::across(2, 0.3), CutPlane::through({0, -0.35, 0}, {0.2, -1, 0})};
  std::map<std::uint32_t, std::size_t> seen;
  for (const double fieldOfView : {0.0, 40.0}) {
    for (const auto& some : {std::span<const CutPlane>(), std::span<const CutPlane>(cuts)}) {
      for (const bool isDraft : {false, true}) {
        const Look look(View::named("iso"), fieldOfView);
        const auto stepped = look.at(tangle, some, {.isDraft = isDraft});
        const auto met = this->byParts(look, tangle, some, isDraft);
        std::size_t others = 0;
        for (std::size_t i = 0; i < met.size(); ++i) {
          const bool isSame =
              met[i].surface == stepped[i].surface &&
              (!met[i].isHit() || std::abs(met[i].along - stepped[i].along) < 0.05 * Look::kPixel);
          others += isSame ? 0 : 1;  // beside silhouettes and where operands meet
          if (met[i].isHit()) ++seen[met[i].surface];
        }
        EXPECT_LT(others, isDraft ? 60U : 5U) << fieldOfView << some.size() << isDraft;
        EXPECT_GT(hits(met), 1000U);
      }
    }
  }
  // Struts, block, both parts of the ball, the other ball, and the faces of both cuts.
  for (const auto surface : {0U, 1U, 2U, 3U, 4U}) EXPECT_GT(seen[surface], 200U) << surface;
  for (const auto cut : {0U, 1U}) EXPECT_GT(seen[SurfaceSample::kCutFace + cut], 1000U) << cut;
  EXPECT_EQ(seen.size(), 7U);
}

TYPED_TEST(SolidTracerTest, PicturesOfPartsAreThoseOfTheUnion) {
  using T = TypeParam;
  const auto tangle = this->tangle();
  const Opaque<T> whole(tangle);
  for (const auto quality : {PictureQuality::Draft, PictureQuality::Final}) {
    auto options = bare(View::named("iso"));
    options.quality = quality;
    options.lines = true;
    options.cuts = {CutPlane::across(2, 0.3)};
    const auto parts = render(tangle, options);
    const auto one = render(whole, options);
    std::size_t others = 0;
    for (std::size_t i = 0; i < parts.pixels().size(); ++i) {
      const bool isSame = difference(parts.pixels()[i], one.pixels()[i]) < 24 &&
                          std::abs(parts.opacities()[i] - one.opacities()[i]) < 64;
      others += isSame ? 0 : 1;
    }
    EXPECT_GT(covered(parts), 20'000);
    EXPECT_LT(static_cast<double>(others), 0.004 * covered(parts));
  }
}

TYPED_TEST(SolidTracerTest, OfFacesInOnePlaceTheFirstOperandsIsSeen) {
  using T = TypeParam;
  const Solid<T> mesh = this->box({T(-0.7), T(-0.7), T(-0.3)}, {T(0.7), T(0.7), T(0.37)});
  const Solid<T> block = Cuboid<T>({T(-0.5), T(-0.5), T(-0.6)}, {T(0.5), T(0.5), T(0.37)});
  const Look look(View::from({0.3, 0.4, 1}));
  for (const bool isDraft : {false, true}) {
    for (const bool meshIsFirst : {false, true}) {
      const Solid<T> both = meshIsFirst ? mesh | block : block | mesh;
      const auto samples = this->byParts(look, both, {}, isDraft);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].isHit()) continue;
        const auto p = look.ray(i).at(samples[i].along);
        const bool isShared = p.z > 0.369 && std::max(std::abs(p.x), std::abs(p.y)) < 0.48;
        if (isShared) {
          ASSERT_EQ(samples[i].surface, 0U) << p.x << ' ' << p.y;
        }
      }
    }
  }
}

TYPED_TEST(SolidTracerTest, WhatIsThinIsSeenBesideWhatHasOnlySigns) {
  using T = TypeParam;
  constexpr T kHalf = T(2e-6);
  const Cuboid<T> plate({T(-0.9), T(-0.9), -kHalf}, {0, T(0.9), kHalf});
  const auto inBall = [](const Vec3<T>& p) {
    return lengthSquared(p - Vec3<T>{T(0.5), 0, 0}) < T(0.16) ? T(-1) : T(1);
  };
  const Solid<T> both = plate | FunctionSDF(inBall, Guarantee<T>{});
  const Look look(View::named("+z"));
  std::array<double, 2> area{};  // of both patches
  for (const auto& sample : this->byParts(look, both, {}, false)) {
    if (sample.isHit()) area[sample.surface] += Look::kPixel * Look::kPixel;
  }
  EXPECT_NEAR(area[0], 0.9 * 1.8, 0.1);
  EXPECT_NEAR(area[1], 0.16 * std::numbers::pi, 0.02);
}

}  // namespace
}  // namespace cutwater::test
