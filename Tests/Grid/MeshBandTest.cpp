#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <vector>

#include "Support/DamagedSoups.hpp"
#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

// Meshes find the points of a band in their own way.

template <typename T>
class MeshBandTest : public ::testing::Test {
 protected:
  /// Compares with the values of all points, in bands down to fractions of a cell.
  static void expectTheValuesOfAll(const SignedDistanceFunction<T>& solid,
                                   const GridPatch<T>& gridPatch) {
    const auto& level = gridPatch.level;
    const auto& indices = gridPatch.indices;
    std::vector<T> expected;
    forEachIndex(indices, [&](const Index3& index) {
      expected.push_back(solid.signedDistance(level.position(index)));
    });
    for (const double band : {0.01, 0.8, 1.0, 2.5, 3.0, 8.0, 100.0}) {
      const T limit = static_cast<T>(band) * level.smallestSpacing();
      for (const int threads : {1, 3}) {
        std::vector<T> values(indices.count(), T(99));
        fill(solid, gridPatch, GridView<T>::contiguous(values.data(), indices),
             {.band = band, .threads = threads});
        for (std::size_t n = 0; n < values.size(); ++n) {
          const T wanted = std::abs(expected[n]) > limit ? std::copysign(limit, expected[n])  //
                                                         : expected[n];
          ASSERT_TRUE(sameBits(values[n], wanted))
              << "band " << band << ", " << threads << " threads: " << values[n] << " at " << n
              << ", not " << wanted;
        }
      }
    }
  }
  /// Cells around a mesh of about this many along its longest side, as long as wide or not.
  static void expectTheValuesOfAll(const PolygonSoup& soup, int cells) {
    Solid<T> solid = MeshSDF<T>(soup);
    for (const bool isTurned : {false, true}) {
      if (isTurned) solid.rotate(T(31), {1, 2, 3});
      const auto box = solid.boundingBox();
      const T h = maxComponent(box.size()) / static_cast<T>(cells);
      for (const Vec3<T> shape : {Vec3<T>{1, 1, 1}, Vec3<T>{T(0.7), T(2.5), T(1.3)}}) {
        const Vec3<T> spacing = h * shape;
        const Vec3<T> size = box.size() + T(14) * Vec3<T>{h, h, h};
        const auto along = [&](int axis) {
          return static_cast<std::int32_t>(size[axis] / spacing[axis]) + 1;
        };
        const Level<T> level(box.lower - T(7) * Vec3<T>{h, h, h}, spacing);
        expectTheValuesOfAll(solid, {level, IndexBox::ofSize(along(0), along(1), along(2))});
      }
    }
  }
};
TYPED_TEST_SUITE(MeshBandTest, Precisions);

TYPED_TEST(MeshBandTest, OfTrianglesLargerThanCells) {
  this->expectTheValuesOfAll(tessellation::box({-1, -0.6, -0.3}, {1, 0.6, 0.3}), 40);
  this->expectTheValuesOfAll(tessellation::torus(1, 0.3, 9, 6), 40);
}

TYPED_TEST(MeshBandTest, OfTrianglesAsLargeAsCells) {
  this->expectTheValuesOfAll(tessellation::torus(1, 0.3, 60, 20), 40);
}

TYPED_TEST(MeshBandTest, OfManyTrianglesInEachCell) {
  this->expectTheValuesOfAll(tessellation::torus(1, 0.3, 240, 100), 16);
}

/// More of them within reach of a few points than any list takes.
TYPED_TEST(MeshBandTest, OfASpeckOfManyTriangles) {
  const auto speck = moved(tessellation::icosphere(0.04, 5), {1.2, 0, 0});
  this->expectTheValuesOfAll(together(tessellation::icosphere(1, 2), speck), 24);
}

/// Distances are those to the nearest triangle, which may be within the solid.
TYPED_TEST(MeshBandTest, OfShellsThatOverlap) {
  const auto ball = tessellation::icosphere(0.8, 2);
  this->expectTheValuesOfAll(together(ball, moved(ball, {0.6, 0.1, 0.05})), 30);
}

TYPED_TEST(MeshBandTest, OfAThinPlateAndAHollowBall) {
  this->expectTheValuesOfAll(tessellation::box({-1, -1, -0.001}, {1, 1, 0.001}, 5), 30);
  this->expectTheValuesOfAll(
      together(tessellation::icosphere(0.8, 2), insideOut(tessellation::icosphere(0.7, 2))), 30);
}

/// Away from holes, open ones do, too.
TYPED_TEST(MeshBandTest, OfOpenSurfaces) {
  const auto ball = tessellation::icosphere(1, 3);
  this->expectTheValuesOfAll(bowl(24), 16);
  this->expectTheValuesOfAll(bowl(24), 40);
  this->expectTheValuesOfAll(sieveOf(ball, 200), 40);
  this->expectTheValuesOfAll(sieveOf(ball, 10), 24);
  this->expectTheValuesOfAll(twistedBand(40, 0.3, 1), 24);
  this->expectTheValuesOfAll(together(sieveOf(ball, 1000), moved(bowl(24), {0.8, 0.1, 0.05})), 30);
}

/// Coordinates have many bits more than their differences.
TYPED_TEST(MeshBandTest, FarFromTheOrigin) {
  const double away = sizeof(TypeParam) == sizeof(float) ? 300 : 1e6;
  this->expectTheValuesOfAll(moved(tessellation::icosphere(1, 3), {away, -2 * away, away / 2}), 24);
}

}  // namespace
}  // namespace cutwater::test
