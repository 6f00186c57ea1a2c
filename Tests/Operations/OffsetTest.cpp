#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OffsetTest : public ::testing::Test {
 protected:
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
  Sphere<T> ball_{{1, 1, 1}, 1};
};
TYPED_TEST_SUITE(OffsetTest, Precisions);

TYPED_TEST(OffsetTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto round = offset(this->box_, T(0.5));
  EXPECT_EQ(round.signedDistance({4, 5, 0}), T(4.5));
  EXPECT_EQ(round.signedDistance({0, 0, 0}), T(-1.5));
  const auto small = offset(this->box_, T(-0.5));
  EXPECT_EQ(small.signedDistance({0, 0, 0}), T(-0.5));
  EXPECT_EQ(small.signedDistance({0, 0, 2}), T(1.5));
  EXPECT_EQ(offset(this->box_, T(0)).signedDistance({4, 5, 0}), T(5));
}

TYPED_TEST(OffsetTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto round = offset(this->box_, T(0.5));
  EXPECT_EQ(round.guarantee().outside, Quality::Exact);
  EXPECT_EQ(round.guarantee().inside, Quality::LowerBound);
  expectGuarantee(round, 2.5, {.inside = [](const Vec3<double>& p) {
                    return length(max(abs(p) - Vec3<double>{1, 1, 1}, Vec3<double>{})) < 0.5;
                  }});
  const auto small = offset(this->box_, T(-0.5));
  EXPECT_EQ(small.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(small.guarantee().inside, Quality::Exact);
  expectGuarantee(small, 2,
                  {.inside = [](const Vec3<double>& p) { return maxComponent(abs(p)) < 0.5; }});
  expectGuarantee(
      offset((this->box_ | this->ball_) - translated(this->ball_, {T(-1.5), 0, 0}), T(0.25)), 3);
  expectGuarantee(offset(this->box_ - this->ball_, T(-0.25)), 2);
  expectGuarantee(offset(scaled(this->box_ - this->ball_, T(0.75)), T(0.25)), 2.5);
}

TYPED_TEST(OffsetTest, OfACombinationHasTheBitsOfTheDirectFormula) {
  using T = TypeParam;
  const auto body = rotated((this->box_ | this->ball_) - translated(this->ball_, {1, 0, 0}), 30, 2);
  const auto grown = offset(body, T(0.3));
  EXPECT_EQ(grown.patchNames().size(), body.patchNames().size());
  for (const Vec3<T> p : {Vec3<T>{3, 2, 1}, {1, 0, T(0.3)}, {-1, T(0.7), 2}}) {
    EXPECT_EQ(grown.signedDistance(p), body.signedDistance(p) - T(0.3));
  }
}

TYPED_TEST(OffsetTest, BoundingBoxesMoveWithTheSurface) {
  using T = TypeParam;
  EXPECT_NEAR(offset(this->box_, T(0.5)).boundingBox().upper.z, T(1.5), tolerance<T>(2, 256));
  EXPECT_NEAR(offset(this->box_, T(-0.5)).boundingBox().upper.z, T(0.5), tolerance<T>(2, 256));
  EXPECT_TRUE(offset(this->box_, T(-3)).boundingBox().empty());
  // Outside, a difference is a lower bound only, yet its box stays finite.
  EXPECT_NEAR(offset(this->box_ - this->ball_, T(0.5)).boundingBox().upper.x, T(1.5),
              tolerance<T>(2, 256));
  // The same as an opaque operand: {f < 0.5} might reach anywhere.
  EXPECT_EQ(Offset<T>(this->box_ - this->ball_, T(0.5)).boundingBox(), Box<T>::everywhere());
}

TYPED_TEST(OffsetTest, ShrunkToNothingHasNoSurface) {
  using T = TypeParam;
  const auto none = offset(this->box_, T(-2));
  EXPECT_EQ(none.classify({{-3, -3, -3}, {3, 3, 3}}), BoxClass::Outside);
  EXPECT_FALSE(none.closestPoint({0, 0, 0}).exact);
  expectGuarantee(none, 3, {.inside = [](const auto&) { return false; }, .hasSurface = false});
}

TYPED_TEST(OffsetTest, TellsTheOwnerOfTheSurfaceBelow) {
  using T = TypeParam;
  const auto grown = Offset<T>(
      named(this->box_, "hull") | named(translated(this->ball_, {4, 0, 0}), "buoy"), T(0.5));
  EXPECT_EQ(grown.closestPoint({9, 1, 1}).owner.patch, 1U);
  EXPECT_EQ(grown.closestPoint({-9, 1, 1}).owner.patch, 0U);
}

TYPED_TEST(OffsetTest, RefusesImpossibleDistances) {
  using T = TypeParam;
  EXPECT_THROW(static_cast<void>(offset(this->box_, std::numeric_limits<T>::infinity())), Error);
  EXPECT_THROW(static_cast<void>(offset(this->box_, std::numeric_limits<T>::quiet_NaN())), Error);
}

}  // namespace
}  // namespace cutwater::test
