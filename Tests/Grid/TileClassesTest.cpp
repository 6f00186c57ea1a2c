#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// A ball that counts values and box queries.
template <std::floating_point T>
class AskedBall final : public SignedDistanceFunction<T> {
 public:
  explicit AskedBall(const Guarantee<T>& promise) : promise_(promise) {}
  mutable std::atomic<std::size_t> values{0};
  mutable std::atomic<std::size_t> boxes{0};

 private:
  T localSignedDistance(const Vec3<T>& p) const override {
    ++values;
    return length(p) - 1;
  }
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override {
    ++boxes;
    return SignedDistanceFunction<T>::localClassify(box, hint);
  }
  Guarantee<T> localGuarantee() const override { return promise_; }

  Guarantee<T> promise_;
};

template <typename T>
class TileClassesTest : public ::testing::Test {
 protected:
  static std::vector<BoxClass> filled(const SignedDistanceFunction<T>& solid,
                                      const GridPatch<T>& gridPatch, int threads = 1) {
    std::vector<BoxClass> classes(gridPatch.indices.count(), BoxClass::Unknown);
    fill(solid, gridPatch,
         FillTargets<T>{.boxClass =
                            GridView<BoxClass>::contiguous(classes.data(), gridPatch.indices)},
         {.threads = threads});
    return classes;
  }

  /// Compares with classify(), cell by cell, on cells and on nodes.
  static void expectClasses(const SignedDistanceFunction<T>& solid) {
    for (const auto centering : {Centering::Cell, Centering::Node}) {
      const Level<T> level({T(0.03), T(-0.02), 0}, {T(0.11), T(0.09), T(0.14)}, centering);
      std::array<int, 4> count{};
      for (const IndexBox& box :
           {IndexBox{{-23, -25, -15}, {19, 22, 16}}, IndexBox{{3, -9, -2}, {40, -7, 2}}}) {
        const auto one = filled(solid, {level, box});
        EXPECT_EQ(one, filled(solid, {level, box}, 3));
        std::size_t n = 0;
        forEachIndex(box, [&](const Index3& index) {
          ASSERT_EQ(one[n], solid.classify(level.cell(index)))
              << index.i << ' ' << index.j << ' ' << index.k;
          ++count[static_cast<std::size_t>(one[n++])];
        });
      }
      EXPECT_GT(count[0], 50);
      EXPECT_GT(count[1], 1000);
      EXPECT_GT(count[2] + count[3], 300);
    }
  }
};
TYPED_TEST_SUITE(TileClassesTest, Precisions);

TYPED_TEST(TileClassesTest, AreThoseOfShapes) {
  using T = TypeParam;
  Solid<T> ring = Torus<T>(1, T(0.4));
  ring.rotate(30, {1, 2, 3});
  ring.translate({T(0.1), T(-0.2), T(0.3)});
  this->expectClasses(ring);
  this->expectClasses(Cuboid<T>({T(-0.96), T(-0.56), -1}, {T(0.6), 1, T(0.84)}));
  this->expectClasses((ring | Sphere<T>({-1, T(0.3), 0}, T(0.7))) -
                      Cuboid<T>({0, 0, 0}, {2, 2, 2}));
}

TYPED_TEST(TileClassesTest, AreThoseOfMeshes) {
  using T = TypeParam;
  const auto closed = tessellation::torus(0.9, 0.4, 24, 15);
  MeshSDF<T> mesh(closed);
  mesh.rotate(20, {3, 1, 2});
  this->expectClasses(mesh);
  PolygonSoup open;
  open.points = closed.points;
  open.patchNames = closed.patchNames;
  for (std::size_t i = 11; i < closed.polygonCount(); ++i) open.addPolygon(closed.polygon(i));
  this->expectClasses(MeshSDF<T>(open));
}

TYPED_TEST(TileClassesTest, AreThoseOfFunctionsThatPromiseLittle) {
  using T = TypeParam;
  auto promise = Guarantee<T>::exact(1);
  promise.domain = {{T(-1.3), T(-1.3), T(-1.3)}, {T(1.3), T(1.3), T(1.3)}};
  const AskedBall<T> within(promise);
  const Level<T> level({T(0.05), 0, 0}, {T(0.1), T(0.1), T(0.1)});
  const IndexBox box{{-16, -16, -16}, {15, 15, 15}};
  const auto classes = this->filled(within, {level, box});
  std::size_t n = 0;
  forEachIndex(box, [&](const Index3& index) {
    ASSERT_EQ(classes[n++], within.classify(level.cell(index)));
  });
  const AskedBall<T> nothing(Guarantee<T>{});
  for (const auto kind : this->filled(nothing, {level, box})) {
    ASSERT_EQ(kind, BoxClass::Unknown);
  }
}

TYPED_TEST(TileClassesTest, AskOnlyNearTheSurface) {
  using T = TypeParam;
  const AskedBall<T> ball(Guarantee<T>::exact(1));
  const Level<T> level({}, {T(0.04), T(0.04), T(0.04)});
  const IndexBox box{{-48, -48, -48}, {47, 47, 47}};
  const auto classes = this->filled(ball, {level, box});
  const auto cut = static_cast<std::size_t>(std::ranges::count(classes, BoxClass::Cut));
  EXPECT_GT(cut, 10000U);
  EXPECT_LT(ball.boxes, 2 * cut);
  EXPECT_LT(ball.values, 30 * cut) << "of 884 736 cells";
}

TYPED_TEST(TileClassesTest, ComeWithEverythingElseInOnePass) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::torus(0.9, 0.4, 24, 15));
  const Level<T> level({T(0.03), T(-0.02), 0}, {T(0.11), T(0.09), T(0.14)});
  const GridPatch<T> gridPatch{level, {{-14, -17, -5}, {13, 16, 6}}};
  const auto count = gridPatch.indices.count();
  for (const double band : {0.0, 2.0}) {
    std::vector<T> distances(count);
    std::vector<std::uint32_t> patches(count);
    std::vector<Vec3<T>> points(2 * count);  // the normal follows its point
    std::vector<BoxClass> classes(count);
    const auto nx = static_cast<std::ptrdiff_t>(gridPatch.indices.length(0));
    const auto ny = static_cast<std::ptrdiff_t>(gridPatch.indices.length(1));
    const std::array<std::ptrdiff_t, 3> pairs{2, 2 * nx, 2 * nx * ny};
    fill(mesh, gridPatch,
         {.distance = GridView<T>::contiguous(distances.data(), gridPatch.indices),
          .patch = GridView<std::uint32_t>::contiguous(patches.data(), gridPatch.indices),
          .closestPoint = {points.data(), pairs},
          .normal = {points.data() + 1, pairs},
          .boxClass = GridView<BoxClass>::contiguous(classes.data(), gridPatch.indices)},
         {.band = band});
    const T limit = band > 0 ? static_cast<T>(band) * level.smallestSpacing() : Box<T>::kInf;
    std::size_t n = 0;
    int near = 0;
    forEachIndex(gridPatch.indices, [&](const Index3& index) {
      const auto hit = mesh.closestPoint(level.position(index));
      if (std::abs(hit.distance) <= limit) {
        ++near;
        ASSERT_TRUE(sameBits(distances[n], hit.distance));
        ASSERT_EQ(patches[n], hit.owner.patch);
        ASSERT_EQ(points[2 * n], hit.point);
        ASSERT_EQ(points[2 * n + 1], hit.normal);
      } else {
        ASSERT_EQ(distances[n], std::copysign(limit, hit.distance));
        ASSERT_EQ(patches[n], kNone);
        for (const auto& p : {points[2 * n], points[2 * n + 1]}) {
          ASSERT_TRUE(std::isnan(p.x) && std::isnan(p.y) && std::isnan(p.z));
        }
      }
      ASSERT_EQ(classes[n], mesh.classify(level.cell(index)));
      ++n;
    });
    EXPECT_EQ(static_cast<std::size_t>(near) == count, band == 0);
    EXPECT_GT(near, 1000);
  }
}

}  // namespace
}  // namespace cutwater::test
