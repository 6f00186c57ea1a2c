#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ComplementTest : public ::testing::Test {
 protected:
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(ComplementTest, Precisions);

TYPED_TEST(ComplementTest, TurnsInsideOut) {
  using T = TypeParam;
  const auto rest = ~this->box_;
  EXPECT_EQ(rest.signedDistance({0, 0, 0}), T(1));
  EXPECT_EQ(rest.signedDistance({4, 5, 0}), T(-5));
  EXPECT_FALSE(std::signbit(rest.signedDistance({1, 0, 0})));  // on the surface: +0
  EXPECT_EQ(rest.closestPoint({3, 0, 0}).normal, (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(rest.closestPoint({3, 0, 0}).distance, T(-2));
  EXPECT_EQ(rest.classify({{2, 2, 2}, {3, 3, 3}}), BoxClass::Inside);
  EXPECT_EQ(rest.classify({{0, 0, 0}, {T(0.5), T(0.5), T(0.5)}}), BoxClass::Outside);
  EXPECT_EQ(rest.classify({{0, 0, 0}, {2, 2, 2}}), BoxClass::Cut);
}

TYPED_TEST(ComplementTest, CountsCrossingsByItsOwnSign) {
  using T = TypeParam;
  const auto rest = ~this->box_;
  bool entering = true;
  const auto count = [&](const Vec3<T>& a, const Vec3<T>& b) {
    return rest
        .crossings({a, b},
                   [&](const Crossing<T>& c) {
                     entering = c.entering;
                     return true;
                   })
        .found;
  };
  EXPECT_EQ(count({3, 0, 0}, {0, 0, 0}), 1U);
  EXPECT_FALSE(entering);
  // The surface is outside of both the box and its complement.
  EXPECT_EQ(count({0, 0, 0}, {1, 0, 0}), 0U);
  EXPECT_EQ(count({3, 0, 0}, {1, 0, 0}), 1U);
}

TYPED_TEST(ComplementTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(~this->box_, 2.5,
                  {.inside = [](const Vec3<double>& p) { return maxComponent(abs(p)) > 1; }});
  const auto two = this->box_ | translated(this->box_, {T(0.5), T(0.5), T(0.5)});
  EXPECT_EQ((~two).guarantee().inside, Quality::Exact);
  EXPECT_EQ((~two).guarantee().outside, Quality::LowerBound);
  expectGuarantee(~two, 2.5);
}

/// Meshes do not look for values beyond what is wanted, which a complement turns around.
TYPED_TEST(ComplementTest, KeepsTheGuaranteeOfMeshes) {
  using T = TypeParam;
  const Solid<T> ring = MeshSDF<T>(tessellation::torus(0.6, 0.2, 16, 8));
  const auto both = ring | translated(rotated(ring, T(90), 0), {T(0.6), 0, 0});
  expectGuarantee(~named(both, "links"), 1.6, {.probes = 2000});
}

}  // namespace
}  // namespace cutwater::test
