#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Detail/SolidParts.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SolidPartsTest : public ::testing::Test {
 protected:
  static std::vector<detail::SolidPart<T>> parts(const SignedDistanceFunction<T>& solid,
                                                 bool sheets = false) {
    return detail::partsOf(solid, {{-3, -3, -3}, {3, 3, 3}}, sheets, 1);
  }
};
TYPED_TEST_SUITE(SolidPartsTest, Precisions);

TYPED_TEST(SolidPartsTest, OperandsAreSortedByHowRaysFindThem) {
  using T = TypeParam;
  const Solid<T> ball = Sphere<T>({}, 1);
  const Solid<T> mesh = MeshSDF<T>(triangulated(tessellation::box({-1, -1, -1}, {1, 1, 1})));
  const FunctionSDF signs([](const Vec3<T>& p) { return p.x < 0 ? T(-1) : T(1); }, Guarantee<T>{});
  const auto whole = this->parts(ball | translated(ball, {1, 0, 0}));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole[0].patches.empty());
  EXPECT_FALSE(whole[0].facets);

  const auto meshes = this->parts(mesh | translated(mesh, {1, 0, 0}));
  ASSERT_EQ(meshes.size(), 1U);
  EXPECT_TRUE(meshes[0].facets);

  const auto mixed = this->parts(signs | ball | named(mesh, "mesh") | translated(ball, {1, 0, 0}));
  ASSERT_EQ(mixed.size(), 3U);
  EXPECT_TRUE(mixed[0].facets);
  EXPECT_EQ(mixed[0].patches, (std::vector{2U}));
  EXPECT_FALSE(mixed[1].facets);
  EXPECT_EQ(mixed[1].patches, (std::vector{1U, 3U}));
  EXPECT_EQ(mixed[2].patches, (std::vector{0U}));

  EXPECT_EQ(this->parts(mesh - ball).size(), 1U);
  EXPECT_EQ(this->parts(mesh | ball, /*sheets=*/true).size(), 1U);
}

}  // namespace
}  // namespace cutwater::test
