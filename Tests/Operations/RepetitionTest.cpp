#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/CountedSolid.hpp"
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

/// Arrays of a small solid, as large and as dense as they may be.
template <typename T>
std::vector<Solid<T>> arraysOf(const Solid<T>& a) {
  constexpr auto kMany = std::numeric_limits<std::uint32_t>::max();
  std::vector<Repeats<T>> all{{.period = {1, 1, 0}, .count = {0, 0, 1}},
                              {.period = {0, 1, 0}},
                              {.period = {1, 1, 1}},
                              {.period = {1, 1, 1}, .count = {1000, 1000, 1000}},
                              {.period = {2, T(0.75), 1}, .count = {kMany, kMany, 1}},
                              {.period = {1, T(1e-3), 1}, .count = {2, kMany, 0}}};
  std::vector<Solid<T>> result;
  for (const auto& repeats : all) result.push_back(repeated(a, repeats));
  return result;
}

/// Along axes and not, for every other magnitude.
template <typename T>
std::vector<Vec3<T>> pointsOfAllMagnitudes() {
  constexpr int kMost = sizeof(T) == sizeof(float) ? 30 : 150;
  std::vector<Vec3<T>> points;
  for (int exponent = -kMost; exponent <= kMost; exponent += 2) {
    const T far = std::pow(T(10), static_cast<T>(exponent));
    for (const T x : {T(0.1), T(0.3) * far}) {
      for (const T y : {T(0.2), T(-0.7) * far}) {
        for (const T z : {T(0), far}) points.push_back({x, y, z});
      }
    }
  }
  return points;
}

TYPED_TEST(RepetitionTest, AsksFewCopiesWhereverThePointIs) {
  using T = TypeParam;
  std::size_t asked = 0;
  const auto most = [&asked](const Solid<T>& solid) {
    std::size_t result = 0;
    for (const auto& p : pointsOfAllMagnitudes<T>()) {
      asked = 0;
      EXPECT_FALSE(std::isnan(solid.signedDistance(p))) << p;
      result = std::max(result, asked);
    }
    return result;
  };
  const Sphere<T> ball({T(0.3), 0, 0}, T(0.3));
  const auto exact = arraysOf(Solid<T>(CountedSolid<T>(ball, &asked)));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(most(exact[i]), 8U) << i;
  EXPECT_LE(most(exact[5]), 8U * 603);  // 601 overlap
  const auto bitten = ball - Sphere<T>({T(0.3), 0, T(0.3)}, T(0.4));
  const auto bounds = arraysOf(Solid<T>(CountedSolid<T>(bitten, &asked)));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(most(bounds[i]), 1000U) << i;
  EXPECT_LE(most(bounds[5]), 3078U);
}

TYPED_TEST(RepetitionTest, ValuesFarAwayAreThoseOfTheNearestCopy) {
  using T = TypeParam;
  // 0.1 and 0.2 beside the middle of the nearest ball; and where it is the last, from that one.
  const auto arrays = arraysOf(Solid<T>(Sphere<T>({T(0.3), 0, 0}, T(0.3))));
  for (int k = 3; k < 48; k += 3) {
    const T far = std::ldexp(T(1), k);
    const Vec3<T> above{T(0.1), T(0.2), far};
    const T value = std::sqrt(T(0.08) + far * far) - T(0.3);
    EXPECT_NEAR(arrays[0].signedDistance(above), value, arrays[0].guarantee().error(far));
    const Vec3<T> beside{T(999.3) + far, T(500.2), T(499.9)};
    const T along = std::sqrt(T(0.05) + far * far) - T(0.3);
    EXPECT_NEAR(arrays[3].signedDistance(beside), along, arrays[3].guarantee().error(far + 1500));
  }
}

/// A cuboid of which a plane leaves the lowest corner: values far above exceed the distance to the
/// box by nearly its height.
template <typename T>
Solid<T> looseInItsBox() {
  return Cuboid<T>({0, 0, 0}, {1, 1, 2}) & Plane<T>({0, 0, T(0.2)}, {T(0.25), T(0.125), 1});
}

TYPED_TEST(RepetitionTest, OfLowerBoundsIsOneBoundNearAndFar) {
  using T = TypeParam;
  std::size_t asked = 0;
  const auto loose = looseInItsBox<T>();
  const auto sheet = repeated(CountedSolid<T>(loose, &asked), {.period = {1, T(1.5), 0}});
  ASSERT_EQ(sheet.guarantee().outside, Quality::LowerBound);
  ASSERT_EQ(sheet.guarantee().lipschitz, T(1));
  // The box is 2 high and has the diagonal sqrt(1 + 1 + 4): from 8 of these on, the value is that
  // of the box, and nothing is asked.
  const T diagonal = std::sqrt(T(6));
  EXPECT_GT(sheet.signedDistance({T(0.4), T(0.4), 6}), T(4.5));
  EXPECT_NEAR(sheet.signedDistance({T(0.4), T(0.4), 2 + 8 * diagonal}), 8 * diagonal,
              tolerance<T>(32, 64));
  EXPECT_NEAR(sheet.signedDistance({T(0.4), T(0.4), T(1e6)}), T(1e6) - 2, tolerance<T>(T(1e6), 64));
  asked = 0;
  static_cast<void>(sheet.signedDistance({T(0.4), T(0.4), 2 + 9 * diagonal}));
  EXPECT_EQ(asked, 0U);
  EXPECT_NEAR(length(sheet.gradient({T(0.4), T(0.4), 2 + 9 * diagonal})), 1, tolerance<T>(1));
  // Just before, what it may exceed that by decides, which shrinks by a quarter of the distance.
  const Vec3<T> justBefore{T(0.4), T(0.4), 2 + T(7.75) * diagonal};
  EXPECT_NEAR(sheet.signedDistance(justBefore), T(7.8125) * diagonal, tolerance<T>(32, 64));
  EXPECT_NEAR(length(sheet.gradient(justBefore)), T(0.75), tolerance<T>(1));
  // In between, it changes no faster than it states, from the one to the other.
  T before = sheet.signedDistance({T(0.4), T(0.4), 2});
  for (int k = 17; k < 200; ++k) {
    const T z = T(0.125) * static_cast<T>(k);
    const T value = sheet.signedDistance({T(0.4), T(0.4), z});
    const T gap = z - 2;
    EXPECT_NEAR(value, before, T(0.125) + 2 * sheet.guarantee().error(30)) << z;
    EXPECT_GE(value, gap - sheet.guarantee().error(30)) << z;
    EXPECT_LE(value, length(Vec3<T>{T(0.4), T(0.4), z - T(0.2)})) << z;  // to a corner
    before = value;
  }
  expectGuarantee(repeated(loose, {.period = {1, T(1.5), 0}}), 22, {.hasSurface = false});
  expectGuarantee(repeated(loose, {.period = {1, T(1.5), 3}, .count = {3, 2, 2}}), 30,
                  {.hasSurface = false});
}

TYPED_TEST(RepetitionTest, BatchesFarAwayAreAsOneByOne) {
  using T = TypeParam;
  for (const auto& solid : arraysOf(looseInItsBox<T>())) {
    const auto points = pointsOfAllMagnitudes<T>();
    std::vector<T> values(points.size());
    solid.signedDistances(points, values);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(values[i], solid.signedDistance(points[i])) << points[i];
    }
  }
}

/// Those of the copies near a box; of very many copies, also of copies, that of all as one.
TYPED_TEST(RepetitionTest, TellsTheSurfacesOfAFewCopies) {
  using T = TypeParam;
  const auto countIn = [](const Solid<T>& solid, const Box<T>& box) {
    int count = 0;
    solid.surfacesIn(box, [&](const Solid<T>&, const Solid<T>*) { ++count; });
    return count;
  };
  const auto few =
      repeated(Sphere<T>({0, 0, 0}, T(0.25)), {.period = {1, 2, 0}, .count = {3, 2, 1}});
  EXPECT_EQ(countIn(few, {{-1, -1, -1}, {3, 3, 1}}), 6);
  EXPECT_EQ(countIn(few, {{T(0.9), T(0.1), 0}, {T(1.1), T(0.3), T(0.2)}}), 1);
  const Vec3<T> period{T(0.05), T(0.05), T(0.05)};
  const Sphere<T> small({0, 0, 0}, T(0.01));
  const Box<T> box{{0, 0, 0}, {3, 3, 3}};
  const auto ofCopies = [&](const Solid<T>& solid) {
    return repeated(solid, {.period = {1, 1, 1}, .count = {3, 3, 3}});
  };
  const auto twelve = repeated(small, {.period = period, .count = {2, 2, 3}});
  const auto thousand = repeated(small, {.period = period, .count = {10, 10, 10}});
  EXPECT_EQ(countIn(ofCopies(twelve), box), 27 * 12);
  EXPECT_EQ(countIn(thousand, box), 1000);
  EXPECT_EQ(countIn(ofCopies(thousand), box), 1);
  EXPECT_EQ(countIn(repeated(small, {.period = period}), box), 1);
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
