// Unions and intersections of many operands, compared with the plain fold over all of them.

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Mesh/Tessellation.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Combination.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <set>
#include <tuple>

#include "Operations/PlainFold.hpp"
#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/SameClosestPoints.hpp"

namespace cutwater::test {
namespace {

/// A mere lower bound: its values are a tenth of the distance, far below that to its box.
template <typename T>
struct Shy final : SignedDistanceFunction<T> {
  explicit Shy(const Vec3<T>& at) : center(at) {}
  T localSignedDistance(const Vec3<T>& p) const override {
    return T(0.1) * (length(p - center) - T(0.25));
  }
  Guarantee<T> localGuarantee() const override {
    auto promise = Guarantee<T>::exact(2);
    promise.outside = promise.inside = Quality::LowerBound;
    promise.lipschitz = T(0.1);
    return promise;
  }
  Box<T> localBoundingBox() const override { return Box<T>{center, center}.grown(T(0.25)); }
  Vec3<T> center;
};

template <typename T>
class OperandTreeTest : public ::testing::Test {
 protected:
  /// Counted from `begin` to `end`: balls, boxes and capsules, moved and not, some deep in others
  /// and some twice.
  static std::vector<Solid<T>> parts(int begin, int end, T size) {
    std::vector<Solid<T>> result;
    RandomPoints<T> random(1, /*seed=*/static_cast<unsigned>(begin + 1));
    for (int i = begin; i < end; ++i) {
      const Vec3<T> at = random.next();
      const Vec3<T> half = size * (abs(random.next()) + Vec3<T>{T(0.1), T(0.1), T(0.1)});
      switch (i % 5) {
        case 0:
          result.push_back(Sphere<T>(at, half.x));
          break;
        case 1:
          result.push_back(Cuboid<T>(at - half, at + half));
          break;
        case 2:
          result.push_back(Capsule<T>(at - half, at + half, half.y));
          break;
        case 3:
          result.push_back(rotated(Cuboid<T>(at - half, at + half), T(7) * half.z / size, at));
          break;
        default:
          result.push_back(result[result.size() / 2]);
      }
    }
    return result;
  }

  /// All kinds that a tree must not mix up, in an order without order.
  static std::vector<Solid<T>> everything() {
    auto result = parts(0, 400, T(0.05));
    result.push_back(Plane<T>({0, 0, T(-0.8)}, {T(0.1), 0, 1}));
    result.push_back(MeshSDF<T>(tessellation::torus(0.5, 0.1, 24, 12)));
    const auto more = parts(400, 900, T(0.03));
    result.insert(result.end(), more.begin(), more.end());
    result.push_back(rotated(scaled(result[7] | result[8], T(-1.5)), T(33), {1, 2, 3}));
    result.push_back(parts(900, 901, T(0.3))[0] - result[17]);  // outside a lower bound only
    result.push_back(rounded(result[3], T(0.02)));
    result.push_back(translated(unionOf(parts(901, 980, T(0.02))), {T(0.2), 0, 0}));
    const auto rest = parts(980, 1040, T(0.04));
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
  }

  /// A block, and all that is taken away from it.
  static std::vector<Solid<T>> block(const std::vector<Solid<T>>& holes) {
    std::vector<Solid<T>> result;
    for (const auto& hole : holes) result.push_back(~hole);
    const auto middle = result.begin() + static_cast<std::ptrdiff_t>(result.size() / 2);
    result.insert(middle, rotated(Cuboid<T>({-1, -1, -1}, {1, 1, 1}), T(10), 2));
    return result;
  }
};
TYPED_TEST_SUITE(OperandTreeTest, Precisions);

template <typename T>
void expectSamePoint(const Solid<T>& solid, const Solid<T>& plain, const Vec3<T>& p) {
  SCOPED_TRACE(testing::Message() << "point " << p);
  EXPECT_PRED2(sameBits<T>, solid.signedDistance(p), plain.signedDistance(p));
  EXPECT_TRUE(isSame(solid.gradient(p), plain.gradient(p)));
  EXPECT_EQ(solid.owner(p), plain.owner(p));
  EXPECT_EQ(differingFields(solid.closestPoint(p), plain.closestPoint(p)), "");
}

template <typename T>
BoxClass expectSameBox(const Solid<T>& solid, const Solid<T>& plain, const Box<T>& box) {
  const auto bounds = solid.bounds(box);
  const auto expected = plain.bounds(box);
  EXPECT_PRED2(sameBits<T>, bounds.lower, expected.lower) << box.lower << box.upper;
  EXPECT_PRED2(sameBits<T>, bounds.upper, expected.upper) << box.lower << box.upper;
  EXPECT_EQ(solid.classify(box), plain.classify(box)) << box.lower << box.upper;
  return solid.classify(box);
}

template <typename T>
void expectSameCrossings(const Solid<T>& solid, const Solid<T>& plain, const Segment<T>& segment) {
  const auto all = [&segment](const Solid<T>& asked) {
    std::vector<T> result;
    const auto count = asked.crossings(segment, [&](const Crossing<T>& c) {
      const auto [object, patch, face] = c.owner;
      result.insert(result.end(), {c.parameter, c.normal.x, c.normal.y, c.normal.z, T(c.entering),
                                   static_cast<T>(object), static_cast<T>(patch), T(face)});
      return true;
    });
    result.push_back(static_cast<T>(count.unresolved));
    return result;
  };
  EXPECT_EQ(all(solid), all(plain)) << segment.start << segment.end;
}

template <typename T>
void expectSameAsPlain(Solid<T> solid, const std::vector<Solid<T>>& operands, bool least) {
  Solid<T> plain = PlainFold<T>(operands, least, solid.guarantee());
  RandomPoints<T> random(T(1.3), /*seed=*/3);
  for (int motion = 0; motion < 2; ++motion) {
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 700; ++i) points.push_back(random.next());
    for (const T far : {T(1e3), T(1e9), T(1e17), T(1e25), T(1e37)}) {
      points.push_back(far * random.next());
    }
    points.push_back({std::numeric_limits<T>::quiet_NaN(), 0, 0});
    std::vector<T> values(points.size());
    solid.signedDistances(points, values);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_PRED2(sameBits<T>, values[i], plain.signedDistance(points[i])) << points[i];
    }
    for (std::size_t i = 0; i + 3 < points.size(); i += 3) expectSamePoint(solid, plain, points[i]);
    std::set<BoxClass> classes;
    for (int i = 0; i < 200; ++i) {
      const auto at = random.next();
      const T size = std::ldexp(T(1), -(i % 12));
      classes.insert(expectSameBox(solid, plain, Box<T>{at, at + size * abs(random.next())}));
    }
    EXPECT_GE(classes.size(), 3U);  // few remain Unknown
    expectSameBox(solid, plain, {{0, 0, 0}, {T(1e20), T(1e20), T(1e20)}});
    expectSameBox(solid, plain, {{-9, -9, -9}, {9, 9, 9}});
    for (int i = 0; i < 4; ++i) expectSameCrossings(solid, plain, {random.next(), random.next()});
    for (auto* moved : {&solid, &plain}) {
      moved->rotate(T(25), {1, 1, 0}, {T(0.1), 0, 0});
      moved->translate({T(0.05), 0, 0});
    }
  }
}

TYPED_TEST(OperandTreeTest, UnionsAreThePlainFoldToTheBit) {
  using T = TypeParam;
  const auto operands = this->everything();
  const auto all = unionOf(operands);
  ASSERT_EQ(all.template as<Combination<T>>()->operands().size(), operands.size());
  expectSameAsPlain(all, operands, true);
}

TYPED_TEST(OperandTreeTest, OperandsThatAreNoDistancesAreNotLost) {
  using T = TypeParam;
  auto operands = this->parts(0, 300, T(0.15));
  const Vec3<T> at{T(0.9), T(0.9), T(0.9)};
  operands.insert(operands.begin() + 77, Shy<T>(at));
  const auto all = unionOf(operands);
  expectSameAsPlain(all, operands, true);
  const Vec3<T> beside = at + Vec3<T>{T(0.5), 0, 0};  // farther from its box than from others
  EXPECT_EQ(all.owner(beside).object, 77U);
  EXPECT_EQ(all.signedDistance(beside), operands[77].signedDistance(beside));
}

TYPED_TEST(OperandTreeTest, SoAreSmallerOnesAndThoseWithoutExceptions) {
  using T = TypeParam;
  for (const int count : {15, 16, 17, 60}) {
    SCOPED_TRACE(count);
    const auto operands = this->parts(0, count, T(0.3));
    expectSameAsPlain(unionOf(operands), operands, true);
  }
}

TYPED_TEST(OperandTreeTest, FromAfarTheFirstOfEqualsDecides) {
  using T = TypeParam;
  RandomPoints<T> random(std::sqrt(std::numeric_limits<T>::epsilon()), /*seed=*/5);
  std::vector<Solid<T>> operands;
  for (int i = 0; i < 300; ++i) operands.push_back(Sphere<T>(random.next(), T(0.01)));
  const auto all = unionOf(operands);
  const Solid<T> plain = PlainFold<T>(operands, true, all.guarantee());
  std::set<std::uint32_t> winners;
  for (int i = 0; i < 3000; ++i) {
    const auto p = std::ldexp(T(1), i % 64 - 8) * normalized(random.next());
    ASSERT_PRED2(sameBits<T>, all.signedDistance(p), plain.signedDistance(p)) << p;
    ASSERT_EQ(all.owner(p).object, plain.owner(p).object) << p;
    winners.insert(all.owner(p).object);
  }
  EXPECT_GT(winners.size(), 10U);
}

/// A ball whose values are rounded down to multiples of 1/64, as its guarantee tells.
template <typename T>
struct Coarse final : SignedDistanceFunction<T> {
  explicit Coarse(const Vec3<T>& at) : ball(at, T(0.001)) {}
  T localSignedDistance(const Vec3<T>& p) const override {
    return std::floor(64 * ball.signedDistance(p)) / 64;
  }
  Guarantee<T> localGuarantee() const override {
    auto promise = Guarantee<T>::exact(2);
    promise.ulps = T(0x1p-6) / std::numeric_limits<T>::epsilon();
    return promise;
  }
  Box<T> localBoundingBox() const override { return ball.boundingBox(); }
  Sphere<T> ball;
};

TYPED_TEST(OperandTreeTest, OfEqualCoarseValuesTheFirstDecides) {
  using T = TypeParam;
  RandomPoints<T> random(1, /*seed=*/5);
  std::vector<Solid<T>> operands;
  for (int i = 0; i < 2000; ++i) operands.push_back(Coarse<T>(random.next()));
  const auto all = unionOf(operands);
  const Solid<T> plain = PlainFold<T>(operands, true, all.guarantee());
  for (int i = 0; i < 1000; ++i) {
    const auto p = random.next();
    ASSERT_EQ(all.signedDistance(p), plain.signedDistance(p)) << p;
    ASSERT_EQ(all.owner(p).object, plain.owner(p).object) << p;
  }
}

TYPED_TEST(OperandTreeTest, ChainsAreThePlainFoldAtEveryLength) {
  using T = TypeParam;
  // Operands come one by one, and now and then several, one of which the tree cannot hold.
  std::vector<Solid<T>> operands = this->parts(0, 14, T(0.1));
  Solid<T> chain = unionOf(operands);
  RandomPoints<T> random(T(1.3), /*seed=*/3);
  for (int step = 0; step < 60; ++step) {
    auto more = this->parts(20 * step, 20 * step + (step % 12 == 7 ? 20 : 1), T(0.1));
    if (step % 10 == 3) more[0] = Shy<T>(random.next());
    for (const auto& one : more) operands.push_back(one);
    chain = chain | unionOf(more);
    const Solid<T> plain = PlainFold<T>(operands, true, chain.guarantee());
    for (int i = 0; i < 20; ++i) expectSamePoint(chain, plain, random.next());
    for (int i = 0; i < 5; ++i) {
      const auto at = random.next();
      expectSameBox(chain, plain, Box<T>{at, at + T(0.1) * abs(random.next())});
    }
  }
  EXPECT_EQ(chain.template as<Combination<T>>()->operands().size(), operands.size());
}

TYPED_TEST(OperandTreeTest, DifferencesAreThePlainFoldToTheBit) {
  using T = TypeParam;
  for (const auto& holes : {this->parts(0, 400, T(0.03)), this->parts(0, 40, T(0.1))}) {
    auto operands = this->block(holes);
    operands.push_back(translated(~holes[5], {T(0.3), T(0.1), 0}));
    expectSameAsPlain(intersectionOf(operands), operands, false);
  }
}

/// Counts how often it is asked. Values are those of a small ball.
template <typename T>
struct Counted final : SignedDistanceFunction<T> {
  Counted(const Vec3<T>& at, int& asked) : ball(at, T(0.01)), calls(&asked) {}
  T localSignedDistance(const Vec3<T>& p) const override {
    ++*calls;
    return ball.signedDistance(p);
  }
  Guarantee<T> localGuarantee() const override { return ball.guarantee(); }
  Box<T> localBoundingBox() const override { return ball.boundingBox(); }
  Sphere<T> ball;
  int* calls;
};

TYPED_TEST(OperandTreeTest, AsksFewOperands) {
  using T = TypeParam;
  int calls = 0;
  std::vector<Solid<T>> balls;
  std::vector<Solid<T>> holes{Cuboid<T>({-1, -1, -1}, {1, 1, 1})};
  RandomPoints<T> random(1);
  for (int i = 0; i < 5000; ++i) {
    balls.push_back(Counted<T>(random.next(), calls));
    holes.push_back(~balls.back());
  }
  Solid<T> chain = balls.front();
  for (std::size_t i = 1; i < 1000; ++i) chain = chain | balls[i];
  for (const auto& solid : {unionOf(balls), intersectionOf(holes), chain}) {
    calls = 0;
    for (int i = 0; i < 100; ++i) std::ignore = solid.signedDistance(random.next());
    EXPECT_LT(calls, 100 * 40);
    calls = 0;
    for (int i = 0; i < 100; ++i) {
      const auto at = random.next();
      std::ignore = solid.bounds({at, at + T(0.02) * abs(random.next())});
    }
    EXPECT_LT(calls, 100 * 60);
  }
}

TYPED_TEST(OperandTreeTest, AsksNobodyTwice) {
  using T = TypeParam;
  int calls = 0;
  std::vector<Solid<T>> holes{Counted<T>({0, 0, 0}, calls)};  // no complement: always asked
  for (const auto& part : this->parts(0, 100, T(0.01))) holes.push_back(~part);
  const auto block = intersectionOf(holes);
  EXPECT_LT(block.signedDistance({T(0.005), 0, 0}), T(0));
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace cutwater::test
