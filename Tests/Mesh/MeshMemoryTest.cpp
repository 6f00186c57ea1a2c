#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <gtest/gtest.h>

#include "Support/AllocationCount.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MeshMemoryTest : public ::testing::Test {};
TYPED_TEST_SUITE(MeshMemoryTest, Precisions);

TYPED_TEST(MeshMemoryTest, IsBuiltInAFewTimesWhatItTakes) {
  const auto soup = tessellation::torus(1.0, 0.35, 200, 100);  // quads
  const AllocationCount allocations;
  const MeshSDF<TypeParam> mesh(soup);
  const auto peak = static_cast<double>(allocations.peakBytes());
  const auto bytes = static_cast<double>(mesh.memoryBytes());
  EXPECT_GT(peak, 1.5 * bytes);  // arrays are copied into one block
  EXPECT_LE(peak, 4 * bytes);
}

}  // namespace
}  // namespace cutwater::test
