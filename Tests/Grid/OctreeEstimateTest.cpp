#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeEstimate.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeEstimateTest : public ::testing::Test {
 protected:
  static Solid<T> ball() { return Sphere<T>({T(0.013), T(-0.021), T(0.007)}, T(0.8)); }
  static Solid<T> torus() {
    Solid<T> solid = MeshSDF<T>(tessellation::torus(0.7, 0.3, 60, 30));
    solid.rotate(20, {1, 2, 3});
    return solid;
  }
  static Solid<T> gyroid() {
    const TpmsField<T> field(TpmsPattern::gyroid(), T(0.8));
    return Solid<T>(TpmsSolid<T>(field, TpmsPart::Wall, T(0.3))) & ball();
  }
  [[nodiscard]] T truth(const Solid<T>& solid, const Refinement<T>& rules,
                        Balance balance = Balance::Corner) const {
    const Octree<T> mesh(solid, domain, rules, {.balance = balance});
    return static_cast<T>(mesh.cells().size());
  }

  const OctreeDomain<T> domain{{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}};
};
TYPED_TEST_SUITE(OctreeEstimateTest, Precisions);

TYPED_TEST(OctreeEstimateTest, CountsCoarseMeshesExactly) {
  using T = TypeParam;
  const auto ball = this->ball();
  for (const auto balance : {Balance::None, Balance::Face, Balance::Edge, Balance::Corner}) {
    for (int level = 0; level <= 4; ++level) {
      const Refinement<T> rules{.cut = level, .bands = {{T(0.2), 2}}};
      const auto found = estimate(ball, this->domain, rules, {.balance = balance});
      EXPECT_EQ(found.deepest(), std::max(level, 2));
      EXPECT_NEAR(found.cells(), this->truth(ball, rules, balance), 1e-3);
    }
  }
  const auto none = estimate(ball, this->domain, {.cut = 4}, {.balance = Balance::None});
  for (int level = 0; level <= 4; ++level) {
    EXPECT_NEAR(none.cells(level), this->truth(ball, {.cut = level}, Balance::None), 1e-3);
  }
  // Also of a mesh that goes on beyond them.
  const auto fine = estimate(ball, this->domain, {.cut = 14});
  for (int level = 0; level <= 3; ++level) {
    EXPECT_NEAR(fine.cells(level), this->truth(ball, {.cut = level}), 1e-3);
  }
}

TYPED_TEST(OctreeEstimateTest, ExtrapolatesFineMeshes) {
  using T = TypeParam;
  using Rules = Refinement<T>;
  const auto expectClose = [&](const Solid<T>& solid, const Rules& rules, double error) {
    const double cells = this->truth(solid, rules);
    ASSERT_GT(cells, 150'000);
    EXPECT_NEAR(estimate(solid, this->domain, rules).cells() / cells, 1, error);
  };
  expectClose(this->ball(), {.cut = 7}, 0.1);
  expectClose(this->torus(), {.cut = 7}, 0.1);
  expectClose(this->gyroid(), {.cut = 6}, 0.1);
  expectClose(this->torus(), {.cut = 6, .bands = {{T(0.05), 6}}}, 0.1);
  expectClose(this->torus(), {.cut = 5, .curvature = typename Rules::Angle{T(4), 7}}, 0.15);
}

TYPED_TEST(OctreeEstimateTest, NamesTheLevelThatFits) {
  const auto ball = this->ball();
  const auto found = estimate(ball, this->domain, {.cut = 14});
  const auto few = this->truth(ball, {.cut = 6});
  EXPECT_EQ(found.finestWithin(1.1 * few), 6);
  EXPECT_EQ(found.finestWithin(0.9 * few), 5);
  EXPECT_EQ(found.finestWithin(1e18), 14);
  EXPECT_EQ(found.finestWithin(79), -1);  // there are 80 roots
  EXPECT_NEAR(found.cells(10) / found.cells(9), 4, 0.2);
  EXPECT_NEAR(found.divided(9) / found.divided(8), 4, 0.2);
  EXPECT_EQ(found.divided(14), 0);
}

TYPED_TEST(OctreeEstimateTest, MeshesEndAtTheirLimit) {
  const auto ball = this->ball();
  const Octree<TypeParam> mesh(ball, this->domain, {.cut = 5});
  const auto count = mesh.cells().size();
  const Octree<TypeParam> same(ball, this->domain, {.cut = 5}, {.maxCells = count});
  EXPECT_EQ(same.cells().size(), count);
  for (const std::size_t most : {count - 1, count / 2, std::size_t{100}, std::size_t{1}}) {
    try {
      const Octree<TypeParam> none(ball, this->domain, {.cut = 5}, {.maxCells = most});
      ADD_FAILURE() << most;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Limit);
      EXPECT_NE(std::string(error.what()).find("at most " + std::to_string(most)),
                std::string::npos);
    }
  }
}

TYPED_TEST(OctreeEstimateTest, RefusesWhatMeshesDo) {
  EXPECT_THROW(static_cast<void>(estimate(this->ball(), this->domain, {.cut = -1})), Error);
  EXPECT_THROW(static_cast<void>(estimate(this->ball(), this->domain, {.cut = 20})), Error);
}

}  // namespace
}  // namespace cutwater::test
