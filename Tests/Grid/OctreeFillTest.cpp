#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>

#include "Support/Grid.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeFillTest : public ::testing::Test {
 protected:
  struct Values {
    std::vector<T> distance;
    std::vector<Vec3<T>> normal;
    std::vector<std::uint32_t> patch;
  };

  [[nodiscard]] Values filled(const OctreeFillOptions& options = {}) const {
    const auto size = mesh.cells().size();
    Values values{std::vector<T>(size), std::vector<Vec3<T>>(size),
                  std::vector<std::uint32_t>(size)};
    fill(solid, mesh, {values.distance, values.normal, values.patch}, options);
    return values;
  }

  const Solid<T> solid = ballAndPlate<T>();
  const Octree<T> mesh = ballAndPlateMesh<T>(4);
};
TYPED_TEST_SUITE(OctreeFillTest, Precisions);

TYPED_TEST(OctreeFillTest, TellsWhatTheClosestPointTellsToTheBit) {
  const auto values = this->filled();
  std::array<std::size_t, 2> owned{};
  for (std::size_t n = 0; n < this->mesh.cells().size(); ++n) {
    const auto center = this->mesh.center(this->mesh.cells()[n]);
    const auto hit = this->solid.closestPoint(center);
    ASSERT_TRUE(sameBits(values.distance[n], this->solid.signedDistance(center)));
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(sameBits(values.normal[n][axis], hit.normal[axis]));
    }
    ASSERT_EQ(values.patch[n], hit.owner.patch);
    ++owned.at(values.patch[n]);
  }
  EXPECT_GT(owned[0], 1000U);
  EXPECT_GT(owned[1], 1000U);
}

TYPED_TEST(OctreeFillTest, FillsThoseThatAreAskedFor) {
  using T = TypeParam;
  const auto all = this->filled();
  const auto size = this->mesh.cells().size();
  std::vector<T> distance(size);
  fill(this->solid, this->mesh, {.distance = distance});
  EXPECT_EQ(distance, all.distance);
  std::vector<Vec3<T>> normal(size);
  fill(this->solid, this->mesh, {.normal = normal});
  EXPECT_EQ(normal, all.normal);
  std::vector<std::uint32_t> patch(size);
  fill(this->solid, this->mesh, {.patch = patch});
  EXPECT_EQ(patch, all.patch);
  fill(this->solid, this->mesh, OctreeTargets<T>{});
}

TYPED_TEST(OctreeFillTest, IsTheSameForAnyNumberOfThreads) {
  const auto one = this->filled({.threads = 1});
  const auto many = this->filled({.threads = 5});
  EXPECT_EQ(one.distance, many.distance);
  EXPECT_EQ(one.normal, many.normal);
  EXPECT_EQ(one.patch, many.patch);
}

TYPED_TEST(OctreeFillTest, TellsItsProgress) {
  double last = 0;
  static_cast<void>(this->filled({.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  }}));
  EXPECT_EQ(last, 1);
}

TYPED_TEST(OctreeFillTest, RefusesArraysOfAnotherLength) {
  using T = TypeParam;
  std::vector<T> distance(5);
  std::vector<Vec3<T>> normal(this->mesh.cells().size() + 1);
  std::vector<std::uint32_t> patch(this->mesh.cells().size() - 1);
  EXPECT_THROW(fill(this->solid, this->mesh, {.distance = distance}), Error);
  EXPECT_THROW(fill(this->solid, this->mesh, {.normal = normal}), Error);
  EXPECT_THROW(fill(this->solid, this->mesh, {.patch = patch}), Error);
  EXPECT_THROW(static_cast<void>(this->filled({.threads = -1})), Error);
}

}  // namespace
}  // namespace cutwater::test
