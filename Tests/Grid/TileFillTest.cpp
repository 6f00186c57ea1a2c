#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <atomic>
#include <functional>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// A function of the test's own, which counts how often it is asked.
template <std::floating_point T>
class Counted final : public SignedDistanceFunction<T> {
 public:
  using Function = std::function<T(const Vec3<T>&)>;
  Counted(Function function, const Guarantee<T>& promise)
      : function_(std::move(function)), promise_(promise) {}

  std::function<Interval<T>(const Box<T>&)> boundsOf;
  mutable std::atomic<std::size_t> count{0};

 private:
  T localSignedDistance(const Vec3<T>& p) const override {
    ++count;
    return function_(p);
  }
  Guarantee<T> localGuarantee() const override { return promise_; }
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override {
    if (!boundsOf) return SignedDistanceFunction<T>::localBounds(box, hint);
    return boundsOf(box.bounds());
  }

  Function function_;
  Guarantee<T> promise_;
};

template <std::floating_point T>
struct Filled {
  std::vector<T> distances;
  std::vector<std::uint32_t> patches;
};

template <std::floating_point T>
Filled<T> filled(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
                 const FillOptions& options) {
  Filled<T> result{std::vector<T>(gridPatch.indices.count(), T(99)),
                   std::vector<std::uint32_t>(gridPatch.indices.count(), 77)};
  fill(solid, gridPatch,
       {.distance = GridView<T>::contiguous(result.distances.data(), gridPatch.indices),
        .patch = GridView<std::uint32_t>::contiguous(result.patches.data(), gridPatch.indices)},
       options);
  return result;
}

/// The contract: each value is that at the point, or the limit. Returns how many are within it.
template <std::floating_point T>
std::size_t expectPointwise(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
                            const FillOptions& options) {
  const auto result = filled(solid, gridPatch, options);
  const T limit = static_cast<T>(options.band) * gridPatch.level.smallestSpacing();
  std::size_t n = 0;
  std::size_t wrong = 0;
  std::size_t within = 0;
  forEachIndex(gridPatch.indices, [&](const Index3& index) {
    const auto p = gridPatch.level.position(index);
    const T exact = solid.signedDistance(p);
    const bool isBeyond = limit > 0 && std::abs(exact) > limit;
    within += isBeyond ? 0 : 1;
    const T expected = isBeyond ? std::copysign(limit, exact) : exact;
    const auto owner = isBeyond ? kNone : solid.closestPoint(p).owner.patch;
    wrong += sameBits(result.distances[n], expected) && result.patches[n] == owner ? 0 : 1;
    ++n;
  });
  EXPECT_EQ(wrong, 0U) << "of " << n << ", band " << options.band << ", threads "
                       << options.threads;
  return within;
}

/// Sizes that are no multiples of a tile's, flat ones, rows and one index alone; below 0, too.
std::vector<IndexBox> oddBoxes() {
  return {{{-19, -9, -11}, {15, 11, 9}}, {{-17, 3, -12}, {30, 3, 10}},
          {{5, -20, 0}, {5, 20, 0}},     {{9, 0, -1}, {9, 0, -1}},
          {{-30, -2, -16}, {2, -1, 15}}, {{40, 40, 40}, {56, 57, 58}}};
}

template <std::floating_point T>
class TileFillTest : public ::testing::Test {
 protected:
  /// All boxes, bands and numbers of threads.
  void expectContract(const SignedDistanceFunction<T>& solid) {
    for (const auto centering : {Centering::Cell, Centering::Node}) {
      const Level<T> level({T(0.03), T(-0.02), 0}, {T(0.11), T(0.09), T(0.14)}, centering);
      for (const auto& box : oddBoxes()) {
        for (const double band : {0.0, 0.5, 2.0, 7.0}) {
          expectPointwise(solid, {level, box}, {.band = band, .threads = band == 2 ? 3 : 1});
        }
      }
    }
  }

  const Sphere<T> ball{{T(0.2), 0, 0}, 1};
  /// 5.8 units long; the ball's band of 3 cells is a small part of it.
  const GridPatch<T> large{Level<T>({}, {T(0.06), T(0.06), T(0.06)}),
                           {{-48, -48, -48}, {47, 47, 47}}};
};
TYPED_TEST_SUITE(TileFillTest, Precisions);

TYPED_TEST(TileFillTest, KeepsTheContractForExactSolids) {
  using T = TypeParam;
  this->expectContract(this->ball);
  this->expectContract(
      rotated(Cuboid<T>({-1, T(-0.5), -1}, {T(0.6), 1, T(0.8)}), T(25), {1, 2, 3}));
  this->expectContract(~scaled(this->ball, T(-1.3)));
}

TYPED_TEST(TileFillTest, KeepsTheContractForBounds) {
  using T = TypeParam;
  this->expectContract((this->ball | Sphere<T>({-1, T(0.3), 0}, T(0.7))) -
                       Cuboid<T>({0, 0, 0}, {2, 2, 2}));
  auto promise = Guarantee<T>::exact(1);
  promise.inside = promise.outside = Quality::LowerBound;
  promise.lipschitz = T(0.5);
  this->expectContract(Counted<T>([](const Vec3<T>& p) { return (length(p) - 1) / 2; }, promise));
  promise.inside = promise.outside = Quality::SignOnly;
  promise.lipschitz = T(3);  // steep enough to leave the band within a cell
  this->expectContract(Counted<T>([](const Vec3<T>& p) { return 3 * (length(p) - 1); }, promise));
}

TYPED_TEST(TileFillTest, KeepsTheContractForMeshes) {
  using T = TypeParam;
  MeshSDF<T> mesh(tessellation::torus(0.9, 0.3, 16, 9));
  mesh.rotate(20, {3, 1, 2}), mesh.translate({T(0.1), T(0.2), T(-0.3)});
  this->expectContract(mesh);
}

TYPED_TEST(TileFillTest, KeepsTheContractForOpenMeshes) {
  using T = TypeParam;
  const auto closed = tessellation::torus(0.9, 0.4, 12, 7);
  PolygonSoup soup;
  soup.points = closed.points;
  soup.patchNames = closed.patchNames;
  for (std::size_t i = 11; i < closed.polygonCount(); ++i) soup.addPolygon(closed.polygon(i));
  const MeshSDF<T> mesh(soup);
  ASSERT_FALSE(mesh.guarantee().lipschitz);
  this->expectContract(mesh);
}

TYPED_TEST(TileFillTest, BelievesNoPromiseOutsideItsDomain) {
  using T = TypeParam;
  auto promise = Guarantee<T>::exact(1);
  promise.domain = {{T(-1.61), T(-1.61), T(-1.61)}, {T(1.61), T(1.61), T(1.61)}};
  const auto wild = [promise](const Vec3<T>& p) {
    return promise.domain.contains(p) ? length(p) - 1 : p.x * p.y - p.z;
  };
  const Counted<T> solid(wild, promise);
  expectPointwise<T>(solid, this->large, {.band = 2});
}

TYPED_TEST(TileFillTest, AllowsForAsMuchRoundingAsIsPromised) {
  using T = TypeParam;
  auto promise = Guarantee<T>::exact(1);
  promise.ulps = T(0.02) / std::numeric_limits<T>::epsilon();
  // Values off by the promised error, in one direction and the other at random points.
  const auto noisy = [promise](const Vec3<T>& p) {
    const T noise = std::sin(T(1e4) * p.x + T(3e3) * p.y + T(7e3) * p.z);
    return length(p) - 1 + std::copysign(promise.error(length(p)), noise);
  };
  const Counted<T> solid(noisy, promise);
  expectPointwise<T>(solid, this->large, {.band = 3});
}

TYPED_TEST(TileFillTest, SkipsWhatOneValueProvesToBeFar) {
  using T = TypeParam;
  const Counted<T> solid([](const Vec3<T>& p) { return length(p) - 1; }, Guarantee<T>::exact(1));
  std::vector<T> values(this->large.indices.count());
  fill(solid, this->large, GridView<T>::contiguous(values.data(), this->large.indices),
       {.band = 3});
  const std::size_t asked = solid.count;
  const auto within = expectPointwise<T>(solid, this->large, {.band = 3});
  EXPECT_GT(within, 10000U);
  EXPECT_GT(asked, within);
  // In the mean over all directions, boxes of 4^3 add 1.9 cells on each side of the band; the
  // rest is for their centres.
  EXPECT_LT(asked, within * 19 / 10);

  // Far from the surface: one for each tile.
  const IndexBox far{{64, 64, 64}, {64 + 31, 64 + 20, 64 + 15}};
  solid.count = 0;
  fill(solid, GridPatch<T>{this->large.level, far}, GridView<T>::contiguous(values.data(), far),
       {.band = 3});
  EXPECT_EQ(solid.count, 4U);
}

TYPED_TEST(TileFillTest, AsksEverywhereWithoutAGuarantee) {
  using T = TypeParam;
  // The ball shows at no point but those near it.
  const auto lonely = [](const Vec3<T>& p) {
    const T d = length(p - Vec3<T>{1, 1, 1}) - T(0.1);
    return d < T(0.1) ? d : T(1000);
  };
  const Counted<T> solid(lonely, Guarantee<T>{});
  std::vector<T> values(this->large.indices.count());
  for (const double band : {0.0, 3.0}) {
    solid.count = 0;
    fill(solid, this->large, GridView<T>::contiguous(values.data(), this->large.indices),
         {.band = band});
    EXPECT_EQ(solid.count, values.size());
  }
  EXPECT_GT(expectPointwise<T>(solid, this->large, {.band = 3}), 50U);
}

TYPED_TEST(TileFillTest, TakesBoundsWhereThereIsNoConstant) {
  using T = TypeParam;
  // Two layers of value 1, with a jump between them.
  Counted<T> solid([](const Vec3<T>& p) { return std::floor(p.z) < 0 ? T(-1) : T(1); },
                   Guarantee<T>{});
  solid.boundsOf = [](const Box<T>& box) -> Interval<T> {
    return {box.lower.z <= 0 ? T(-1) : T(1), box.upper.z >= 0 ? T(1) : T(-1)};
  };
  std::vector<T> values(this->large.indices.count());
  fill(solid, this->large, GridView<T>::contiguous(values.data(), this->large.indices),
       {.band = 3});
  EXPECT_EQ(solid.count, 0U);  // the jump is between two tiles
  EXPECT_EQ(expectPointwise<T>(solid, this->large, {.band = 3}), 0U);
}

TYPED_TEST(TileFillTest, LeavesOutNoValueThatIsNotANumber) {
  using T = TypeParam;
  const auto holed = [](const Vec3<T>& p) {
    return p.x > 1 ? std::numeric_limits<T>::quiet_NaN() : p.x - T(0.5);
  };
  const Counted<T> solid(holed, Guarantee<T>{});
  std::vector<T> values(this->large.indices.count());
  fill(solid, this->large, GridView<T>::contiguous(values.data(), this->large.indices),
       {.band = 3});
  std::size_t n = 0;
  forEachIndex(this->large.indices, [&](const Index3& index) {
    ASSERT_EQ(std::isnan(values[n++]), this->large.level.position(index).x > 1);
  });
}

}  // namespace
}  // namespace cutwater::test
