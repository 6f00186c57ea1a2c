#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameClosestPoints.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ClosestPointsTest : public ::testing::Test {
 protected:
  /// Some anywhere, some that tie: on a lattice, most of them with several nearest triangles; more
  /// than a batch, and not a multiple of one.
  static std::vector<Vec3<T>> points() {
    std::vector<Vec3<T>> result;
    RandomPoints<T> random(2);
    for (int i = 0; i < scaled(700); ++i) result.push_back(random.next());
    for (int i = 0; i < 343; ++i) {
      result.push_back(T(0.5) * Vec3<T>{T(i % 7 - 3), T(i / 7 % 7 - 3), T(i / 49 - 3)});
    }
    result.push_back({T(1e30), T(-1e30), 0});
    return result;
  }

  const PolygonSoup ball_ = tessellation::icosphere(1, 3);
  const PolygonSoup box_ = tessellation::box({-1, -1, -1}, {1, 1, 1}, 4);
};
TYPED_TEST_SUITE(ClosestPointsTest, Precisions);

TYPED_TEST(ClosestPointsTest, OfMeshesAreTheSameInBatches) {
  using T = TypeParam;
  const MeshSDF<T> closed(this->box_);
  expectSameClosestPoints(closed, this->points());
  const MeshSDF<T> open(bowl(24));
  EXPECT_FALSE(open.signReport().isClosed());
  expectSameClosestPoints(open, this->points());
  const MeshSDF<T> overlapping(together(this->ball_, moved(this->box_, {0.75, 0.5, 0.25})),
                               {.findSelfIntersections = true});
  EXPECT_FALSE(overlapping.signReport().isSound());
  expectSameClosestPoints(overlapping, this->points());
  expectSameClosestPoints(DcelSDF<T>(DcelMesh<T>(tessellation::icosphere(1, 2))), this->points());
}

TYPED_TEST(ClosestPointsTest, OfCompositesAreTheSameInBatches) {
  using T = TypeParam;
  const Solid<T> ball = MeshSDF<T>(this->ball_);
  const Solid<T> box = MeshSDF<T>(this->box_);
  auto turned = box;
  turned.rotate(35, {1, 2, 3});
  turned.translate({T(0.5), T(-0.25), T(0.125)});
  const Torus<T> ring(1, T(0.25));
  expectSameClosestPoints(ring, this->points());
  expectSameClosestPoints(turned, this->points());
  expectSameClosestPoints(ball | turned | ring, this->points());
  expectSameClosestPoints(turned - (scaled(ball, T(0.75)) | ring), this->points());
  expectSameClosestPoints(offset(~scaled(turned, T(-1.5)), T(0.125)), this->points());
}

}  // namespace
}  // namespace cutwater::test
