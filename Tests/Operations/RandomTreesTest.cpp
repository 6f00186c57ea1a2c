#include <algorithm>
#include <sstream>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/RandomTrees.hpp"
#include "Support/SameClosestPoints.hpp"
#include "Support/Scale.hpp"
#include "Support/SurfaceSamples.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RandomTreesTest : public ::testing::Test {
 protected:
  /// How far from the origin it is worth looking: all of a bounded solid, and no farther than the
  /// guarantee holds. 0 if that is hardly anywhere.
  static double extentOf(const Solid<T>& solid) {
    const auto box = solid.boundingBox();
    double extent = 3;
    if (!box.empty() && isFinite(box)) {
      extent = 1.2 * double{maxComponent(max(abs(box.lower), abs(box.upper)))};
      extent = std::clamp(extent, 0.5, 8.0);
    }
    const auto domain = solid.guarantee().domain;
    if (domain == Box<T>::everywhere()) return extent;
    const auto within = min(domain.upper, T(-1) * domain.lower);
    // Checks ask at points of up to twice the extent.
    const double reach = std::min({double{within.x}, double{within.y}, double{within.z}});
    return std::isfinite(reach) && reach > 0.5 ? std::min(extent, reach / 4) : 0;
  }

  struct Checked {
    GuaranteeCounts counts;
    bool hasSurface = false;
  };

  static Checked expectTree(unsigned seed, int depth) {
    // One in four of numbers that a person would choose: faces are aligned, distances equal.
    const auto solid = RandomTrees<T>(seed, seed % 4 == 3 ? 0.125 : 0).tree(depth);
    const double extent = extentOf(solid);
    if (extent == 0) return {};
    const SurfaceSamples<T> samples(solid, extent, 12, 1);
    GuaranteeOptions options{.probes = 250, .lines = 16, .seed = seed};
    options.hasSurface = samples.points().size() > 50;
    const bool hadFailure = ::testing::Test::HasFailure();
    const auto counts = expectGuarantee(solid, extent, options);
    if (!hadFailure && ::testing::Test::HasFailure()) {
      ADD_FAILURE() << "tree of seed " << seed << " and depth " << depth << ", extent " << extent
                    << ":\n"
                    << solid.describe();
    }
    return {counts, options.hasSurface};
  }

  /// A quarter, for each depth, of 10^4 pairs of points and 10^3 boxes for a precision; and of 100
  /// times as many where Scripts/test --all scales trees and points by ten.
  static void expectTrees(int depth) {
    const std::int64_t pairs = scaled(scaled(2500));
    const std::int64_t boxes = scaled(scaled(250));
    GuaranteeCounts counts;
    int all = 0;
    int checked = 0;
    const int most = scaled(25);
    while ((counts.pairs < pairs || counts.boxes < boxes) && all < most &&
           !::testing::Test::HasFailure()) {
      const auto tree = expectTree(static_cast<unsigned>(10000 * depth + all), depth);
      counts += tree.counts;
      checked += tree.hasSurface ? 1 : 0;
      ++all;
    }
    ::testing::Test::RecordProperty("counts", text(counts, all));
    if (::testing::Test::HasFailure()) return;
    EXPECT_GE(counts.pairs, pairs) << text(counts, all);
    EXPECT_GE(counts.boxes, boxes) << text(counts, all);
    EXPECT_GE(2 * counts.distances, pairs) << text(counts, all);
    EXPECT_GE(2 * checked, all) << "hardly any has a surface";
  }

  static std::string text(const GuaranteeCounts& counts, int trees) {
    std::ostringstream result;
    result << trees << " trees, " << counts.pairs << " pairs, " << counts.distances
           << " distances, " << counts.boxes << " boxes";
    return result.str();
  }

  /// Calls check(tree, other tree) for some of each depth; a failing one is told.
  template <typename Check>
  static void forTrees(int count, const Check& check) {
    for (int i = 0; i < scaled(count) && !::testing::Test::HasFailure(); ++i) {
      const auto seed = static_cast<unsigned>(i + 1);
      RandomTrees<T> trees(seed);
      const auto a = trees.tree(1 + i % 4);
      const auto b = trees.tree(i % 3);
      check(a, b);
      if (!::testing::Test::HasFailure()) continue;
      ADD_FAILURE() << "trees of seed " << seed << ":\n" << a.describe() << b.describe();
    }
  }

  /// Values are the same bits, of the second at points shifted by this much.
  static void expectSame(const Solid<T>& a, const Solid<T>& b, const Vec3<T>& shift = {}) {
    RandomPoints<T> points(3);
    for (int i = 0; i < 50 && !::testing::Test::HasFailure(); ++i) {
      const auto p = coarse(points.next());
      const T first = a.signedDistance(p);
      const T second = b.signedDistance(p + shift);
      EXPECT_TRUE(isSame(first, second)) << p << ' ' << first << ' ' << second;
    }
  }
  /// Multiples of 1/1024: sums of such are exact.
  static Vec3<T> coarse(const Vec3<T>& p) {
    return {std::round(p.x * 1024) / 1024, std::round(p.y * 1024) / 1024,
            std::round(p.z * 1024) / 1024};
  }
};
TYPED_TEST_SUITE(RandomTreesTest, Precisions);

TYPED_TEST(RandomTreesTest, OfOneOperatorKeepTheirGuarantee) {
  this->expectTrees(1);
}
TYPED_TEST(RandomTreesTest, OfTwoLevelsKeepTheirGuarantee) {
  this->expectTrees(2);
}
TYPED_TEST(RandomTreesTest, OfThreeLevelsKeepTheirGuarantee) {
  this->expectTrees(3);
}
TYPED_TEST(RandomTreesTest, OfFourLevelsKeepTheirGuarantee) {
  this->expectTrees(4);
}

/// So that a union of many such is asked through a tree; that values keep to it is checked above.
TYPED_TEST(RandomTreesTest, MostBoundedOnesKnowABoxThatBoundsTheirValues) {
  using T = TypeParam;
  int bounded = 0;
  int known = 0;
  this->forTrees(100, [&](const Solid<T>& a, const Solid<T>&) {
    const auto box = a.boundingBox();
    if (a.guarantee().outside != Quality::LowerBound || box.empty() || !isFinite(box)) return;
    ++bounded;
    known += isFinite(a.clearanceBox()) ? 1 : 0;
  });
  EXPECT_GT(bounded, 20);
  EXPECT_GT(10 * known, 7 * bounded) << known << " of " << bounded;
}

TYPED_TEST(RandomTreesTest, IdentitiesHoldToTheBit) {
  using T = TypeParam;
  this->forTrees(60, [this](const Solid<T>& a, const Solid<T>& b) {
    this->expectSame(a, ~~a);
    this->expectSame(~(a | b), ~a & ~b);
    this->expectSame(~(a & b), ~a | ~b);
    this->expectSame(a - b, ~(~a | b));
    this->expectSame(a ^ b, b ^ a);
    const Smoothing<T> smoothing{.reach = T(0.25)};
    this->expectSame(~smoothUnion(a, b, smoothing), smoothIntersection(~a, ~b, smoothing));
    for (const T factor : {T(4), T(-0.125)}) {
      this->expectSame(a, scaled(scaled(a, factor), 1 / factor));
    }
    this->expectSame(a,
                     mirrored(mirrored(a, {1, 2, 3}, {T(0.3), 0, 0}), {1, 2, 3}, {T(0.3), 0, 0}));
    this->expectSame(a, rotated(mirrored(mirrored(named(a, "a"), {0, 1, 0}), {0, 0, 1}), 180, 0));
  });
}

TYPED_TEST(RandomTreesTest, MovingTheSolidIsMovingThePoint) {
  using T = TypeParam;
  this->forTrees(100, [this](const Solid<T>& a, const Solid<T>&) {
    // Named, it has no placement of its own, to which the offset would be added with rounding.
    const Vec3<T> offset{8, T(-0.5), T(0.0625)};
    this->expectSame(a, translated(named(a, "a"), offset), offset);
  });
}

TYPED_TEST(RandomTreesTest, BatchesAreAsOneByOne) {
  using T = TypeParam;
  this->forTrees(100, [](const Solid<T>& a, const Solid<T>&) {
    RandomPoints<T> random(2);
    std::vector<Vec3<T>> points(300);
    for (auto& p : points) p = random.next();
    std::vector<T> values(points.size());
    a.signedDistances(points, values);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(isSame(values[i], a.signedDistance(points[i]))) << points[i];
    }
  });
}

/// The most that a query of each kind asks, per shape of the tree.
struct MostAsked {
  double value = 0;
  double closestPoint = 0;
  double bounds = 0;
  double classify = 0;
  double crossings = 0;
};

/// Asks one tree at points of all magnitudes, some on an axis.
template <typename T>
void askFarAndNear(unsigned seed, int depth, MostAsked& most) {
  std::size_t asked = 0;
  RandomTrees<T> trees(seed, seed % 4 == 3 ? 0.125 : 0, &asked);
  const auto solid = trees.tree(depth);
  RandomPoints<T> random(1, seed);
  const auto note = [&](double& worst, const auto& query) {
    asked = 0;
    query();
    worst = std::max(worst, static_cast<double>(asked) / trees.leaves());
  };
  constexpr int kMost = sizeof(T) == sizeof(float) ? 30 : 150;
  for (int exponent = -kMost; exponent <= kMost; exponent += kMost / 15) {
    const T far = std::pow(T(10), static_cast<T>(exponent));
    auto p = far * random.next();
    const auto q = far * random.next();
    if (seed % 3 == 0) p = {T(0.1), T(0.2), p.z};
    const Box<T> box{min(p, q), max(p, q)};
    const auto goOn = [](const Crossing<T>&) { return true; };
    note(most.value, [&] { static_cast<void>(solid.signedDistance(p)); });
    note(most.closestPoint, [&] { static_cast<void>(solid.closestPoint(p)); });
    note(most.bounds, [&] { static_cast<void>(solid.bounds(box)); });
    note(most.classify, [&] { static_cast<void>(solid.classify(box)); });
    note(most.crossings, [&] { static_cast<void>(solid.crossings({p, q}, goOn)); });
    note(most.crossings, [&] { static_cast<void>(solid.crossings({p, -p}, goOn)); });
  }
}

TYPED_TEST(RandomTreesTest, WorkIsLimitedWhereverThePointIs) {
  MostAsked most;
  for (unsigned seed = 1; seed <= static_cast<unsigned>(scaled(60)); ++seed) {
    askFarAndNear<TypeParam>(seed, /*depth=*/1 + static_cast<int>(seed % 6), most);
  }
  // Several times the worst of 4000 trees; before there was a limit, some did not end.
  EXPECT_LE(most.value, 500);
  EXPECT_LE(most.bounds, 500);
  EXPECT_LE(most.classify, 4000);
  EXPECT_LE(most.closestPoint, 50'000);
  EXPECT_LE(most.crossings, 4e6);
}

TYPED_TEST(RandomTreesTest, DescribeEveryShapeInALine) {
  int described = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    RandomTrees<TypeParam> trees(seed);
    const auto text = trees.tree(static_cast<int>(seed % 5)).describe();
    if (text.find(" more\n") != std::string::npos) continue;  // more than 16 operands
    ++described;
    std::istringstream lines(text);
    int shapes = 0;
    std::size_t depthBefore = 0;
    for (std::string line; std::getline(lines, line);) {
      const auto depth = line.find_first_not_of(' ') / 2;
      shapes += depth <= depthBefore && depthBefore > 0 ? 1 : 0;
      EXPECT_LE(depth, depthBefore + 1);
      EXPECT_NE(line.find(": "), std::string::npos) << line;
      EXPECT_NE(line.find("; "), std::string::npos) << line;
      depthBefore = depth;
    }
    EXPECT_EQ(shapes + 1, trees.leaves()) << "seed " << seed << "\n" << text;
  }
  EXPECT_GT(described, 150);
}

}  // namespace
}  // namespace cutwater::test
