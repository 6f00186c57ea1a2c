#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameClosestPoints.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CombinationTest : public ::testing::Test {
 protected:
  Sphere<T> left_{{-1, 0, 0}, 2};
  Sphere<T> right_{{1, 0, 0}, 2};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(CombinationTest, Precisions);

TYPED_TEST(CombinationTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Solid<T> both = this->left_ | this->right_;
  const Solid<T> lens = this->left_ & this->right_;
  const Solid<T> moon = this->left_ - this->right_;
  for (const T x : {T(-4), T(-2), T(0), T(0.5), T(5)}) {
    const T a = std::abs(x + 1) - 2;
    const T b = std::abs(x - 1) - 2;
    EXPECT_EQ(both.signedDistance({x, 0, 0}), std::min(a, b));
    EXPECT_EQ(lens.signedDistance({x, 0, 0}), std::max(a, b));
    EXPECT_EQ(moon.signedDistance({x, 0, 0}), std::max(a, -b));
  }
}

TYPED_TEST(CombinationTest, DerivesItsGuarantee) {
  const auto check = [](const auto& g, Quality outside, Quality inside) {
    EXPECT_EQ(g.outside, outside);
    EXPECT_EQ(g.inside, inside);
    EXPECT_EQ(g.lipschitz, 1);
    EXPECT_TRUE(g.continuous);
  };
  const auto a = this->left_;
  const auto b = this->right_;
  check((a | b).guarantee(), Quality::Exact, Quality::LowerBound);
  check((a & b).guarantee(), Quality::LowerBound, Quality::Exact);
  check((a - b).guarantee(), Quality::LowerBound, Quality::Exact);
  check(((a | b) - a).guarantee(), Quality::LowerBound, Quality::LowerBound);
  check((a - (a | b)).guarantee(), Quality::LowerBound, Quality::Exact);
  check((a - (a & b)).guarantee(), Quality::LowerBound, Quality::LowerBound);
  check(unionOf(a).guarantee(), Quality::Exact, Quality::Exact);
}

TYPED_TEST(CombinationTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const Torus<T> ring(T(1.5), T(0.5));
  const Cylinder<T> pipe({-2, T(0.1), 0}, {2, T(0.1), T(0.3)}, T(0.5));
  const auto in = [](const auto& solid) {
    return [&solid](const Vec3<double>& p) { return solid.signedDistance(Vec3<T>(p)) < 0; };
  };
  const auto inBox = in(this->box_);
  const auto inRing = in(ring);
  const auto inPipe = in(pipe);
  expectGuarantee(this->box_ | ring, 3,
                  {.inside = [&](const Vec3<double>& p) { return inBox(p) || inRing(p); }});
  expectGuarantee(this->box_ & ring, 2.5,
                  {.inside = [&](const Vec3<double>& p) { return inBox(p) && inRing(p); }});
  expectGuarantee(this->box_ - pipe, 2,
                  {.inside = [&](const Vec3<double>& p) { return inBox(p) && !inPipe(p); }});
  expectGuarantee(
      unionOf(this->box_, ring, pipe) - translated(pipe, {0, 0, T(0.75)}), 3,
      {.inside = [&](const Vec3<double>& p) {
        return (inBox(p) || inRing(p) || inPipe(p)) && !inPipe(p - Vec3<double>{0, 0, 0.75});
      }});
  expectGuarantee(translated(rotated(this->box_, 30, {1, 2, 3}) | ring, {1, 0, 0}), 3);
}

TYPED_TEST(CombinationTest, ForwardsToTheOperandThatDecides) {
  using T = TypeParam;
  const auto body = named(this->left_, "port") | named(this->right_, "starboard") |
                    named(translated(this->box_, {0, 0, 9}), "mast");
  EXPECT_EQ(body.patchNames(), (std::vector<std::string>{"port", "starboard", "mast"}));
  const auto right = body.closestPoint({7, 0, 0});
  EXPECT_TRUE(right.exact);
  EXPECT_EQ(right.point, (Vec3<T>{3, 0, 0}));
  EXPECT_EQ(right.owner.object, 1U);
  EXPECT_EQ(right.owner.patch, 1U);
  EXPECT_EQ(body.closestPoint({0, 0, 12}).owner.patch, 2U);
  EXPECT_EQ(body.closestPoint({0, 5, 0}).owner.patch, 0U) << "of equals the first";
  EXPECT_EQ(body.gradient({7, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(body.owner({-3, 0, 0}).patch, 0U);

  std::vector<std::uint32_t> patches;
  body.crossings({{-5, 0, 0}, {5, 0, 0}}, [&](const Crossing<T>& c) {
    patches.push_back(c.owner.patch);
    return true;
  });
  EXPECT_EQ(patches, (std::vector<std::uint32_t>{0, 1}));
}

TYPED_TEST(CombinationTest, ClosestPointsWithinAnotherOperandAreReplaced) {
  using T = TypeParam;
  const auto body = this->left_ | this->right_;
  // The nearest point of the left ball, (1, 0, 0), is deep in the right one.
  const auto c = body.closestPoint({T(-0.25), 0, 0});
  EXPECT_NEAR(body.signedDistance(c.point), T(0), tolerance<T>(4));
  EXPECT_FALSE(c.exact);
  // Truly nearest is the circle in which they meet, of radius sqrt(3).
  EXPECT_LE(length(c.point - Vec3<T>{T(-0.25), 0, 0}) - c.tolerance, std::sqrt(T(3.0625)));
}

TYPED_TEST(CombinationTest, OfEqualOperandsTheFirstDecidesInBatchesToo) {
  using T = TypeParam;
  std::vector<Vec3<T>> between;  // as far from one ball as from the other
  for (int i = 0; i < 100; ++i) between.push_back({0, T(i - 50), T(0.5)});
  expectSameClosestPoints(this->left_ | this->right_, between);
  expectSameClosestPoints(this->left_ & this->right_, between);
  EXPECT_EQ((this->left_ | this->right_).closestPoint({0, 3, 0}).owner.object, 0U);
}

TYPED_TEST(CombinationTest, ClosestPointsOfASharpEdgeAreFound) {
  using T = TypeParam;
  // A wedge of about 11 degrees: steps alternate between its planes many times.
  const auto wedge = Plane<T>({0, 0, 0}, {0, 1, T(0.1)}) & Plane<T>({0, 0, 0}, {0, -1, T(0.1)});
  const auto c = wedge.closestPoint({0, T(0.25), 1});
  EXPECT_NEAR(wedge.signedDistance(c.point), T(0), tolerance<T>(2, 64));
  EXPECT_NEAR(length(c.point), T(0), T(1e-3));
}

TYPED_TEST(CombinationTest, FlattensChainsUnlessTheyWereMoved) {
  using T = TypeParam;
  const auto a = this->left_;
  const auto chain = a | a | a | (a | a);
  ASSERT_NE(chain.template as<Combination<T>>(), nullptr);
  EXPECT_EQ(chain.template as<Combination<T>>()->decides(), Combination<T>::Decides::Least);
  EXPECT_EQ(chain.template as<Combination<T>>()->operands().size(), 5U);
  EXPECT_EQ((translated(a | a, {1, 0, 0}) | a).template as<Combination<T>>()->operands().size(),
            2U);
  Solid<T> many = a;
  for (int i = 1; i < 2000; ++i) many = many | translated(a, {T(4 * i), 0, 0});
  std::vector<Vec3<T>> points(300, Vec3<T>{T(4 * 1999 - 1), 0, 0});
  std::vector<T> values(points.size());
  many.signedDistances(points, values);
  EXPECT_EQ(values[299], T(-2));
}

TYPED_TEST(CombinationTest, ClassifiesOnlyWhatIsCertain) {
  using T = TypeParam;
  const auto both = this->left_ | this->right_;
  EXPECT_EQ(both.classify({{0, T(-0.4), T(-0.4)}, {T(0.1), T(0.4), T(0.4)}}), BoxClass::Inside);
  EXPECT_EQ(both.classify({{5, -1, -1}, {6, 1, 1}}), BoxClass::Outside);
  EXPECT_EQ(both.classify({{2, -1, -1}, {4, 1, 1}}), BoxClass::Cut);
  // The left ball's surface passes here, but within the right ball.
  EXPECT_EQ(both.classify({{T(0.9), T(-0.1), T(-0.1)}, {T(1.1), T(0.1), T(0.1)}}),
            BoxClass::Inside);
  const auto hollow = this->left_ - this->left_;  // nothing is left but a false zero
  EXPECT_NE(hollow.classify({{T(0.9), T(-0.1), T(-0.1)}, {T(1.1), T(0.1), T(0.1)}}), BoxClass::Cut);
}

TYPED_TEST(CombinationTest, BoundingBoxesFollowTheOperands) {
  using T = TypeParam;
  const auto both = (this->left_ | this->right_).boundingBox();
  EXPECT_NEAR(both.lower.x, T(-3), tolerance<T>(4, 64));
  EXPECT_NEAR(both.upper.x, T(3), tolerance<T>(4, 64));
  EXPECT_NEAR((this->left_ & this->right_).boundingBox().upper.x, T(1), tolerance<T>(4, 64));
  EXPECT_NEAR((this->left_ - this->right_).boundingBox().upper.x, T(1), tolerance<T>(4, 64));
  EXPECT_TRUE((this->left_ & translated(this->left_, {9, 0, 0})).boundingBox().empty());
}

TEST(Combination, RefusesToBeEmpty) {
  EXPECT_THROW(static_cast<void>(unionOf(std::vector<Solid<double>>{})), Error);
  EXPECT_THROW(static_cast<void>(intersectionOf(std::vector<Solid<float>>{})), Error);
}

}  // namespace
}  // namespace cutwater::test
