// Unions and intersections of many operands, compared with the plain fold over all of them.

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <tuple>

#include "Operations/ManyOperands.hpp"
#include "Support/Precisions.hpp"

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
  /// All kinds that a tree must not mix up, in an order without order.
  static std::vector<Solid<T>> everything() {
    auto result = parts<T>(0, 400, T(0.05));
    result.push_back(Plane<T>({0, 0, T(-0.8)}, {T(0.1), 0, 1}));
    result.push_back(MeshSDF<T>(tessellation::torus(0.5, 0.1, 24, 12)));
    const auto more = parts<T>(400, 900, T(0.03));
    result.insert(result.end(), more.begin(), more.end());
    result.push_back(rotated(scaled(result[7] | result[8], T(-1.5)), T(33), {1, 2, 3}));
    result.push_back(parts<T>(900, 901, T(0.3))[0] - result[17]);  // outside a lower bound only
    result.push_back(offset(result[3], T(0.02)));
    result.push_back(translated(unionOf(parts<T>(901, 980, T(0.02))), {T(0.2), 0, 0}));
    const auto rest = parts<T>(980, 1040, T(0.04));
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
  }
};
TYPED_TEST_SUITE(OperandTreeTest, Precisions);

TYPED_TEST(OperandTreeTest, UnionsAreThePlainFoldToTheBit) {
  using T = TypeParam;
  const auto operands = this->everything();
  const auto all = unionOf(operands);
  ASSERT_EQ(all.template as<Combination<T>>()->operands().size(), operands.size());
  expectSameAsPlain(all, operands, true);
}

/// Of which each is asked only for values up to the best so far.
TYPED_TEST(OperandTreeTest, UnionsOfMeshesAreThePlainFoldToTheBit) {
  using T = TypeParam;
  const Solid<T> ring = MeshSDF<T>(tessellation::torus(0.2, 0.08, 16, 8));
  const Solid<T> ball = MeshSDF<T>(tessellation::icosphere(0.15, 2));
  RandomPoints<T> random(1);
  std::vector<Solid<T>> meshes;
  for (int i = 0; i < 120; ++i) {
    const auto axis = random.next();
    auto mesh = rotated(i % 2 == 0 ? ring : ball, 180 * random.next().x, axis);
    if (i % 3 == 0) mesh = scaled(mesh, T(-0.7));
    if (i % 5 == 0) mesh = mirrored(named(mesh, "mesh"), axis);
    meshes.push_back(translated(mesh, random.next()));
  }
  expectSameAsPlain(unionOf(meshes), meshes, true);
  const auto remains = block(meshes);
  expectSameAsPlain(intersectionOf(remains), remains, false);
}

TYPED_TEST(OperandTreeTest, OperandsThatAreNoDistancesAreNotLost) {
  using T = TypeParam;
  auto operands = parts<T>(0, 300, T(0.15));
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
    const auto operands = parts<T>(0, count, T(0.3));
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
  std::vector<Solid<T>> operands = parts<T>(0, 14, T(0.1));
  Solid<T> chain = unionOf(operands);
  RandomPoints<T> random(T(1.3), /*seed=*/3);
  for (int step = 0; step < 60; ++step) {
    auto more = parts<T>(20 * step, 20 * step + (step % 12 == 7 ? 20 : 1), T(0.1));
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
  for (const auto& holes : {parts<T>(0, 400, T(0.03)), parts<T>(0, 40, T(0.1))}) {
    auto operands = block(holes);
    operands.push_back(translated(~holes[5], {T(0.3), T(0.1), 0}));
    expectSameAsPlain(intersectionOf(operands), operands, false);
  }
}

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
  for (const auto& part : parts<T>(0, 100, T(0.01))) holes.push_back(~part);
  const auto block = intersectionOf(holes);
  EXPECT_LT(block.signedDistance({T(0.005), 0, 0}), T(0));
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace cutwater::test
