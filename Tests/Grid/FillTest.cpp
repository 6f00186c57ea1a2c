#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <vector>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// Two half-spheres of a kind: the surface belongs to patch 0 below z = 0 and to patch 1 above.
template <std::floating_point T>
class TwoPatchBall final : public SignedDistanceFunction<T> {
  T localSignedDistance(const Vec3<T>& p) const override { return length(p) - 1; }
  Guarantee<T> localGuarantee() const override { return Guarantee<T>::exact(1); }
  SurfaceOwner localOwner(const Vec3<T>& p) const override {
    return {.object = 0, .patch = p.z < 0 ? 0U : 1U, .face = kNone};
  }
};

template <typename T>
class FillTest : public ::testing::Test {
 protected:
  FillTest() { solid.rotate(30, {1, 2, 3}), solid.translate({T(0.1), T(-0.2), T(0.3)}); }

  T pointwise(const Index3& index) const { return solid.signedDistance(level.position(index)); }

  /// Negative indices, unequal spacings; more than one run of work, and not a multiple of it.
  const Level<T> level{{T(0.05), 0, T(-0.1)}, {T(0.11), T(0.13), T(0.17)}};
  const IndexBox box{{-13, -11, -7}, {12, 9, 11}};
  Solid<T> solid = Sphere<T>({T(0.2), 0, 0}, 1);
};
TYPED_TEST_SUITE(FillTest, Precisions);

TYPED_TEST(FillTest, GivesThePointwiseBitsForAnyNumberOfThreads) {
  using T = TypeParam;
  for (const auto centering : {Centering::Cell, Centering::Node}) {
    const Level<T> centred(this->level.origin(), this->level.spacing(), centering);
    for (const int threads : {1, 2, 5}) {
      std::vector<T> values(this->box.count(), T(99));
      fill(this->solid, GridPatch<T>{centred, this->box},
           GridView<T>::contiguous(values.data(), this->box), {.threads = threads});
      std::size_t n = 0;
      forEachIndex(this->box, [&](const Index3& index) {
        const T expected = this->solid.signedDistance(centred.position(index));
        ASSERT_TRUE(sameBits(values[n++], expected)) << index.i << ' ' << index.j << ' ' << index.k;
      });
    }
  }
}

TYPED_TEST(FillTest, ManyPatchesGiveTheBitsOfOne) {
  using T = TypeParam;
  std::vector<T> whole(this->box.count());
  fill(this->solid, GridPatch<T>{this->level, this->box},
       GridView<T>::contiguous(whole.data(), this->box));
  for (const int size : {1, 3, 8}) {
    // Each grid patch writes its part of the same array, through the array's strides.
    std::vector<T> parts(whole.size(), T(99));
    const auto all = GridView<T>::contiguous(parts.data(), this->box);
    const Index3 lo = this->box.lo;
    const Index3 hi = this->box.hi;
    forEachIndex(IndexBox{{0, 0, 0}, {26 / size, 21 / size, 19 / size}}, [&](const Index3& tile) {
      const Index3 from{lo.i + tile.i * size, lo.j + tile.j * size, lo.k + tile.k * size};
      const Index3 to{std::min(from.i + size - 1, hi.i), std::min(from.j + size - 1, hi.j),
                      std::min(from.k + size - 1, hi.k)};
      const GridPatch<T> gridPatch{this->level, {from, to}};
      if (gridPatch.indices.empty()) return;
      auto* first =
          &all.at(static_cast<std::size_t>(from.i - lo.i), static_cast<std::size_t>(from.j - lo.j),
                  static_cast<std::size_t>(from.k - lo.k));
      fill(this->solid, gridPatch, GridView<T>{first, all.stride});
    });
    for (std::size_t n = 0; n < whole.size(); ++n) ASSERT_TRUE(sameBits(parts[n], whole[n])) << n;
  }
}

TYPED_TEST(FillTest, WritesOneComponentOfAnyLayoutAndNothingElse) {
  using T = TypeParam;
  // z fastest, y backwards, the second of three interleaved components.
  constexpr std::ptrdiff_t kComponents = 3;
  const auto ny = static_cast<std::ptrdiff_t>(this->box.length(1));
  const auto nz = static_cast<std::ptrdiff_t>(this->box.length(2));
  std::vector<T> values(this->box.count() * kComponents, T(99));
  const GridView<T> view{values.data() + (ny - 1) * nz * kComponents + 1,
                         {nz * ny * kComponents, -nz * kComponents, kComponents}};
  fill(this->solid, GridPatch<T>{this->level, this->box}, view);
  forEachIndex(this->box, [&](const Index3& index) {
    const auto& lo = this->box.lo;
    const T* value =
        &view.at(static_cast<std::size_t>(index.i - lo.i), static_cast<std::size_t>(index.j - lo.j),
                 static_cast<std::size_t>(index.k - lo.k));
    ASSERT_TRUE(sameBits(*value, this->pointwise(index)));
    ASSERT_EQ(value[-1], T(99));
    ASSERT_EQ(value[1], T(99));
  });
}

TYPED_TEST(FillTest, BeyondTheBandIsExactlyItsWidth) {
  using T = TypeParam;
  const T limit = T(1.5) * T(0.11);
  std::vector<T> values(this->box.count());
  fill(this->solid, GridPatch<T>{this->level, this->box},
       GridView<T>::contiguous(values.data(), this->box), {.band = 1.5});
  std::size_t n = 0;
  std::size_t within = 0, inside = 0, outside = 0;
  forEachIndex(this->box, [&](const Index3& index) {
    const T exact = this->pointwise(index);
    const T value = values[n++];
    if (std::abs(exact) <= limit) {
      ASSERT_TRUE(sameBits(value, exact));
      ++within;
    } else {
      ASSERT_EQ(value, exact < 0 ? -limit : limit);
      ++(exact < 0 ? inside : outside);
    }
  });
  EXPECT_GT(within, 100U);
  EXPECT_GT(inside, 100U);
  EXPECT_GT(outside, 100U);
}

TYPED_TEST(FillTest, TellsTheClosestPatchInTheSamePass) {
  using T = TypeParam;
  const TwoPatchBall<T> ball;
  const GridPatch<T> gridPatch{this->level, this->box};
  std::vector<T> distances(this->box.count());
  std::vector<std::uint32_t> ids(this->box.count(), 77);
  const FillTargets<T> targets{.distance = GridView<T>::contiguous(distances.data(), this->box),
                               .patch = GridView<std::uint32_t>::contiguous(ids.data(), this->box)};
  for (const double band : {0.0, 2.0}) {
    fill(ball, gridPatch, targets, {.band = band});
    std::size_t n = 0;
    std::size_t beyond = 0;
    forEachIndex(this->box, [&](const Index3& index) {
      const auto p = this->level.position(index);
      const bool told = band == 0 || std::abs(length(p) - 1) <= T(2) * T(0.11);
      beyond += told ? 0 : 1;
      ASSERT_EQ(ids[n++], !told ? kNone : p.z < 0 ? 0U : 1U) << p;
    });
    EXPECT_EQ(beyond > 0, band > 0);
  }
  std::vector<std::uint32_t> alone(this->box.count(), 77);
  fill(ball, gridPatch, {.patch = GridView<std::uint32_t>::contiguous(alone.data(), this->box)},
       {.band = 2});
  EXPECT_EQ(alone, ids);
}

TYPED_TEST(FillTest, AMeshHasTheSameBitsWithItsPatchesAsWithout) {
  using T = TypeParam;
  MeshSDF<T> mesh(tessellation::torus(0.9, 0.3, 12, 8));
  mesh.rotate(20, {3, 1, 2});
  const GridPatch<T> gridPatch{this->level, this->box};
  std::vector<T> distances(this->box.count());
  std::vector<std::uint32_t> ids(this->box.count(), 77);
  for (const double band : {0.0, 100.0}) {
    fill(mesh, gridPatch,
         {.distance = GridView<T>::contiguous(distances.data(), this->box),
          .patch = GridView<std::uint32_t>::contiguous(ids.data(), this->box)},
         {.band = band});
    std::size_t n = 0;
    forEachIndex(this->box, [&](const Index3& index) {
      ASSERT_TRUE(sameBits(distances[n], mesh.signedDistance(this->level.position(index))));
      ASSERT_EQ(ids[n++], 0U);
    });
  }
}

TYPED_TEST(FillTest, ReportsProgressAndStopsWhenToldTo) {
  using T = TypeParam;
  std::vector<T> values(this->box.count());
  const GridPatch<T> gridPatch{this->level, this->box};
  const auto view = GridView<T>::contiguous(values.data(), this->box);
  double last = 0;
  fill(this->solid, gridPatch, view, {.progress = [&](double done) {
         EXPECT_GE(done, last);
         last = done;
       }});
  EXPECT_EQ(last, 1.0);
  struct Cancelled {};
  EXPECT_THROW(fill(this->solid, gridPatch, view, {.progress = [](double) { throw Cancelled(); }}),
               Cancelled);
}

TYPED_TEST(FillTest, RefusesImpossibleOptionsAndAcceptsEmptyPatches) {
  using T = TypeParam;
  T value = 7;
  const GridPatch<T> one{this->level, {{0, 0, 0}, {0, 0, 0}}};
  const GridView<T> view{&value, {1, 1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fill(this->solid, one, view, {.band = -1}), Error);
  EXPECT_THROW(fill(this->solid, one, view, {.band = nan}), Error);
  EXPECT_THROW(fill(this->solid, one, view, {.threads = -1}), Error);
  fill(this->solid, GridPatch<T>{this->level, {{0, 0, 0}, {-1, 5, 5}}}, view);
  EXPECT_EQ(value, T(7));
  fill(this->solid, one, view);
  EXPECT_TRUE(sameBits(value, this->pointwise({0, 0, 0})));
}

}  // namespace
}  // namespace cutwater::test
