#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <limits>
#include <vector>

#include "Support/AllocationCount.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/SameClosestPoints.hpp"

namespace cutwater::test {
namespace {

// So many points that a mesh takes them in an order of its own.

template <typename T>
class ManyPointsTest : public ::testing::Test {
 protected:
  ManyPointsTest() {
    RandomPoints<T> random(4);
    for (int i = 0; i < 140001; ++i) points_.push_back(random.next());
    points_[7].y = std::numeric_limits<T>::quiet_NaN();
    points_[139999].z = std::numeric_limits<T>::infinity();
  }

  std::vector<Vec3<T>> points_;
};
TYPED_TEST_SUITE(ManyPointsTest, Precisions);

TYPED_TEST(ManyPointsTest, HaveTheDistancesOfSingleOnes) {
  using T = TypeParam;
  Solid<T> mesh = MeshSDF<T>(tessellation::torus(0.8, 0.3, 40, 20));
  mesh.rotate(T(20), {1, 2, 3});
  const Solid<T> composite = offset(mesh | Sphere<T>({1, 0, 0}, T(0.5)), T(0.01));
  for (const auto& solid : {mesh, composite}) {
    std::vector<T> expected;
    for (const auto& p : this->points_) expected.push_back(solid.signedDistance(p));
    for (const int threads : {1, 3}) {
      std::vector<T> distances(this->points_.size(), T(99));
      solid.signedDistances(this->points_, distances, {.threads = threads});
      for (std::size_t i = 0; i < distances.size(); ++i) {
        ASSERT_TRUE(isSame(distances[i], expected[i])) << i;
      }
    }
  }
}

TYPED_TEST(ManyPointsTest, NeedNoMemory) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::icosphere(1, 2));
  std::vector<T> expected(this->points_.size());
  mesh.signedDistances(this->points_, expected, {.threads = 1});
  AllocationCount memory;
  for (int n = 1; n <= 3; ++n) {
    std::vector<T> distances(this->points_.size());
    const auto before = memory.count();
    memory.failAt(n);
    mesh.signedDistances(this->points_, distances, {.threads = 1});
    EXPECT_GE(memory.count(), before + n) << "it is asked for";
    memory.failAt(0);
    EXPECT_TRUE(std::ranges::equal(distances, expected, [](T a, T b) { return isSame(a, b); }));
  }
}

TYPED_TEST(ManyPointsTest, HaveTheClosestPointsOfSingleOnes) {
  using T = TypeParam;
  expectSameClosestPoints(MeshSDF<T>(tessellation::torus(0.8, 0.3, 40, 20)), this->points_);
}

}  // namespace
}  // namespace cutwater::test
