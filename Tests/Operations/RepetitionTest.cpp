#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RepetitionTest : public ::testing::Test {
 protected:
  /// The union of copies -reach..reach, or 0..count - 1, asked one by one.
  Solid<T> copies(const Solid<T>& a, const Repeats<T>& repeats, int reach) {
    std::vector<Solid<T>> all;
    const auto range = [&](int axis) {
      const auto count = static_cast<int>(repeats.count[static_cast<std::size_t>(axis)]);
      if (!(repeats.period[axis] > 0)) return std::pair{0, 0};
      return count == 0 ? std::pair{-reach, reach} : std::pair{0, count - 1};
    };
    for (int x = range(0).first; x <= range(0).second; ++x) {
      for (int y = range(1).first; y <= range(1).second; ++y) {
        for (int z = range(2).first; z <= range(2).second; ++z) {
          const auto& d = repeats.period;
          all.push_back(translated(a, Vec3<T>{static_cast<T>(x) * d.x, static_cast<T>(y) * d.y,
                                              static_cast<T>(z) * d.z}));
        }
      }
    }
    return unionOf(all);
  }

  void expectUnion(const Solid<T>& a, const Repeats<T>& repeats, int reach, T extent) {
    const auto whole = repeated(a, repeats);
    const auto all = copies(a, repeats, reach);
    RandomPoints<T> points(extent);
    for (int i = 0; i < 1000; ++i) {
      const auto p = points.next();
      const T allowed = whole.guarantee().error(length(p)) + all.guarantee().error(length(p));
      EXPECT_NEAR(whole.signedDistance(p), all.signedDistance(p), allowed) << p;
    }
  }

  Sphere<T> ball_{{0, 0, 0}, T(0.5)};
  /// Neither symmetric nor within its tile.
  Capsule<T> rod_{{T(0.2), 0, 0}, {T(1.5), T(0.75), T(0.5)}, T(0.25)};
};
TYPED_TEST_SUITE(RepetitionTest, Precisions);

TYPED_TEST(RepetitionTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto rows = repeated(this->ball_, {.period = {2, 4, 0}});
  EXPECT_EQ(rows.signedDistance({0, 0, 0}), T(-0.5));
  EXPECT_EQ(rows.signedDistance({-200, 400, 0}), T(-0.5));
  EXPECT_EQ(rows.signedDistance({1, 0, 0}), T(0.5));
  EXPECT_EQ(rows.signedDistance({0, 2, 0}), T(1.5));
  EXPECT_EQ(rows.signedDistance({0, 0, 9}), T(8.5));
  EXPECT_EQ(rows.gradient({T(2.75), 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(rows.closestPoint({T(2.75), 0, 0}).point, (Vec3<T>{T(2.5), 0, 0}));
  EXPECT_TRUE(rows.closestPoint({T(2.75), 0, 0}).exact);
  const auto three = repeated(this->ball_, {.period = {2, 0, 0}, .count = {3, 1, 0}});
  EXPECT_EQ(three.signedDistance({-2, 0, 0}), T(1.5));
  EXPECT_EQ(three.signedDistance({4, 0, 0}), T(-0.5));
  EXPECT_EQ(three.signedDistance({9, 0, 0}), T(4.5));
  EXPECT_NEAR(three.boundingBox().upper.x, T(4.5), tolerance<T>(8, 256));
  EXPECT_NEAR(three.boundingBox().lower.x, T(-0.5), tolerance<T>(8, 256));
  EXPECT_EQ(rows.boundingBox().upper.y, std::numeric_limits<T>::infinity());
  EXPECT_LT(rows.boundingBox().upper.z, T(0.6));
}

TYPED_TEST(RepetitionTest, IsTheUnionOfTheCopies) {
  using T = TypeParam;
  this->expectUnion(this->rod_, {.period = {1, T(1.25), T(1.5)}}, 6, 3);
  this->expectUnion(this->rod_, {.period = {T(0.4), 3, 0}}, 16, 3);
  this->expectUnion(this->rod_, {.period = {1, T(1.25), 2}, .count = {3, 2, 4}}, 0, 8);
  this->expectUnion(this->rod_, {.period = {3, 0, 1}, .count = {0, 0, 3}}, 6, 5);
  this->expectUnion(this->ball_ - this->rod_, {.period = {1, 1, 2}, .count = {2, 3, 1}}, 0, 3);
  const InfiniteCylinder<T> pipe({0, 0, 0}, {0, 0, 1}, T(0.75));
  this->expectUnion(pipe, {.period = {2, 1, 0}}, 6, 4);
}

TYPED_TEST(RepetitionTest, OfTheCentralCopyAloneIsWrong) {
  using T = TypeParam;
  // Control: the copy whose tile the point is in is not the nearest.
  const auto whole = repeated(this->rod_, {.period = {2, 2, 2}});
  RandomPoints<T> points(1);
  int wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    wrong += this->rod_.signedDistance(p) > whole.signedDistance(p) + T(0.01) ? 1 : 0;
  }
  EXPECT_GT(wrong, 50);
}

TYPED_TEST(RepetitionTest, DerivesItsGuarantee) {
  using T = TypeParam;
  const auto check = [](const auto& solid, Quality outside, Quality inside) {
    EXPECT_EQ(solid.guarantee().outside, outside);
    EXPECT_EQ(solid.guarantee().inside, inside);
    EXPECT_EQ(solid.guarantee().lipschitz, T(1));
  };
  check(repeated(this->ball_, {.period = {2, 2, 2}}), Quality::Exact, Quality::Exact);
  check(repeated(this->ball_, {.period = {1, 2, 2}}), Quality::Exact, Quality::LowerBound);
  check(repeated(this->ball_, {.period = {1, 2, 2}, .count = {1, 2, 2}}), Quality::Exact,
        Quality::Exact);
  check(repeated(this->ball_ - this->rod_, {.period = {2, 2, 2}}), Quality::LowerBound,
        Quality::Exact);
}

TYPED_TEST(RepetitionTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(repeated(this->ball_, {.period = {T(1.5), 2, 0}}), 3);
  expectGuarantee(repeated(this->rod_, {.period = {1, T(1.25), T(1.5)}}), 2.5);
  expectGuarantee(repeated(this->rod_, {.period = {2, 1, 1}, .count = {2, 3, 1}}), 4.5);
  const auto bitten = Cuboid<T>({0, 0, 0}, {1, 1, 1}) - Sphere<T>({1, 1, 1}, T(0.75));
  expectGuarantee(repeated(bitten, {.period = {T(1.5), T(1.25), 3}}), 3);
  const auto moved = rotated(repeated(bitten, {.period = {2, 2, 2}, .count = {2, 2, 2}}), 30, 2);
  expectGuarantee(translated(moved, {1, 0, 0}), 5);
}

TYPED_TEST(RepetitionTest, BoundsCountAtLeastAsTheDistanceToTheBox) {
  using T = TypeParam;
  // A pill of half length 4, whose own value grows by only 1/4 along its axis.
  const AffineMap<T> stretch{{{{4, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}};
  const auto pill = transformed(Sphere<T>({0, 0, 0}, 1), stretch);
  EXPECT_NEAR(pill.signedDistance({5, 0, 0}), T(0.25), tolerance<T>(1));
  const auto row = repeated(pill, {.period = {10, 0, 0}});
  EXPECT_NEAR(row.signedDistance({5, 0, 0}), T(1), tolerance<T>(8, 256));
  EXPECT_NEAR(row.signedDistance({105, 0, 0}), T(1), tolerance<T>(100, 64));
  EXPECT_NEAR(row.signedDistance({5, 3, 0}), T(2.25), tolerance<T>(8, 64));  // its own is more
  EXPECT_NEAR(row.gradient({T(4.5), 0, 0}).x, T(1), tolerance<T>(1));
  expectGuarantee(row, 8);
}

TYPED_TEST(RepetitionTest, FarAwayCopiesRoundAsItStates) {
  const auto make = [](auto scalar) {
    using S = decltype(scalar);
    return repeated(Sphere<S>({S(0.25), 0, 0}, S(0.5)), {.period = {S(1.5), S(2.25), S(3)}});
  };
  // Powers of two and their sums: the periods are the same numbers in both.
  expectRounding(make(float{}), make(double{}), 2);
  using T = TypeParam;
  const T far = T(1e30);  // where neighbouring copies are the same number
  EXPECT_TRUE(std::isfinite(make(T{}).signedDistance({far, -far, far})));
}

TYPED_TEST(RepetitionTest, RoundsWithTheSizeOfTheLargestCount) {
  using T = TypeParam;
  constexpr auto kMost = std::numeric_limits<std::uint32_t>::max();
  const auto row = repeated(this->ball_, {.period = {2, 0, 0}, .count = {kMost, 1, 1}});
  EXPECT_GE(row.guarantee().size, T(0x1p33));
}

TYPED_TEST(RepetitionTest, OfNothingChangesNoFasterThanItStates) {
  using T = TypeParam;
  // Nothing is left of the small ball, but its box, and values larger than the distance to that.
  const auto gone = Sphere<T>({0, 0, 0}, T(0.125)) - Sphere<T>({T(0.25), 0, 0}, 1);
  const auto row = repeated(gone, {.period = {T(0.5), 0, 0}});
  ASSERT_EQ(row.guarantee().lipschitz, T(1));
  constexpr T kStep = T(0x1p-10);
  for (int i = -1024; i < 1024; ++i) {
    const T x = T(i) * kStep;
    EXPECT_NEAR(row.signedDistance({x, 0, 0}), row.signedDistance({x + kStep, 0, 0}),
                kStep + 2 * row.guarantee().error(1));
    EXPECT_GT(row.signedDistance({x, 0, 0}), 0);
  }
  // Without a box, copies are not compared.
  const auto apart = Sphere<T>({0, 0, 0}, 1) & Sphere<T>({4, 0, 0}, 1);
  const auto nothing = repeated(apart, {.period = {2, 0, 0}}).guarantee();
  EXPECT_FALSE(nothing.lipschitz);
  EXPECT_FALSE(nothing.continuous);
}

TYPED_TEST(RepetitionTest, RefusesImpossiblePeriods) {
  using T = TypeParam;
  const auto refuses = [](const Solid<T>& a, const Repeats<T>& repeats) {
    EXPECT_THROW(static_cast<void>(repeated(a, repeats)), Error);
  };
  refuses(this->ball_, {.period = {0, 0, 0}});
  refuses(this->ball_, {.period = {1, -1, 0}});
  refuses(this->ball_, {.period = {std::numeric_limits<T>::infinity(), 0, 0}});
  refuses(this->ball_, {.period = {1, 0, 0}, .count = {1, 2, 1}});
  refuses(this->ball_, {.period = {T(0.001), T(0.001), 1}});
  refuses(Plane<T>({0, 0, 0}, {0, 0, 1}), {.period = {1, 0, 0}});
}

}  // namespace
}  // namespace cutwater::test
