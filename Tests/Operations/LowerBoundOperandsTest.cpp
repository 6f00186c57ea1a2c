// Unions and differences of many operands whose values outside are lower bounds.

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <tuple>

#include "Operations/ManyOperands.hpp"
#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class LowerBoundOperandsTest : public ::testing::Test {};
TYPED_TEST_SUITE(LowerBoundOperandsTest, Precisions);

/// Two rings that overlap, as one mesh.
template <typename T>
Solid<T> overlappingRings() {
  const auto ring = tessellation::torus(0.1, 0.05, 12, 8);
  const auto other = withPoints(ring, [](const Vec3<double>& p) {
    return p + Vec3<double>{0.05, 0, 0};
  });
  return MeshSDF<T>(together(ring, other), {.findSelfIntersections = true});
}

/// Of one or two operands at about the same place.
template <typename T>
Solid<T> combinedLowerBound(std::size_t kind, const Solid<T>& a, const Solid<T>& b) {
  const auto beside = translated(a, {T(0.01), T(0.02), T(0.01)});
  const Smoothing<T> smoothing{.reach = T(0.02)};
  switch (kind) {
    case 0:
      return a & beside;
    case 1:
      return smoothUnion(a, b, smoothing);
    case 2:
      return smoothIntersection(a, beside, smoothing);
    case 3:
      return smoothDifference(a, b, smoothing);
    case 4:
      return offset(smoothDifference(a, beside, smoothing), T(0.01));
    case 5:
      return (a - b) ^ beside;
    default:
      return blended(a, beside, T(0.3));
  }
}

/// Of a lower bound about this place.
template <typename T>
Solid<T> changedLowerBound(std::size_t kind, const Solid<T>& a, const Vec3<T>& at) {
  switch (kind) {
    case 0:
      return shell(a, T(0.004));
    case 1:
      return elongated(a, {T(0.01), 0, T(0.02)});
    case 2:
      return folded(a, {1, 2, 3}, at);
    case 3:
      return repeated(a, {.period = {T(0.2), 0, 0}, .count = {3, 0, 0}});
    case 4:
      return mirrored(scaled(named(a, "drilled"), T(-0.8)), {3, 2, 1}, at);
    default:
      return offset(named(a, "drilled"), T(-0.002));
  }
}

/// Operands whose values outside are lower bounds, of every kind that keeps clear of a box.
template <typename T>
std::vector<Solid<T>> lowerBounds(const std::vector<Solid<T>>& parts) {
  const auto rings = overlappingRings<T>();
  std::vector<Solid<T>> result;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const auto& a = parts[i];
    const auto at = a.boundingBox().center();
    const auto drilled = a - translated(Solid<T>(Sphere<T>({0, 0, 0}, T(0.02))), at);
    const auto kind = i % 16;
    result.push_back(kind < 7    ? combinedLowerBound(kind, a, parts[i + 1])
                     : kind < 13 ? changedLowerBound(kind - 7, drilled, at)
                     : kind < 15 ? drilled
                                 : rotated(translated(rings, at), T(40), at, {1, 2, 0}));
    EXPECT_TRUE(isFinite(result.back().clearanceBox())) << kind;
    EXPECT_NE(result.back().guarantee().outside, Quality::Exact) << kind;
  }
  return result;
}

TYPED_TEST(LowerBoundOperandsTest, UnionsAreThePlainFoldToTheBit) {
  using T = TypeParam;
  const auto operands = lowerBounds(parts<T>(0, 200, T(0.06)));
  expectSameAsPlain(unionOf(operands), operands, true);
}

TYPED_TEST(LowerBoundOperandsTest, DifferencesAreThePlainFoldToTheBit) {
  using T = TypeParam;
  const auto operands = block(lowerBounds(parts<T>(0, 100, T(0.06))));
  expectSameAsPlain(intersectionOf(operands), operands, false);
}

TYPED_TEST(LowerBoundOperandsTest, AsksFewDrilledOnes) {
  using T = TypeParam;
  int calls = 0;
  std::vector<Solid<T>> drilled;
  RandomPoints<T> random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto at = random.next();
    const Solid<T> hole = Capsule<T>(at, at + T(0.02) * random.next(), T(0.002));
    drilled.push_back(rotated(scaled(Counted<T>(at, calls) - hole, T(1.1)), T(20), 2));
  }
  const auto all = unionOf(drilled);
  for (int i = 0; i < 100; ++i) std::ignore = all.signedDistance(random.next());
  EXPECT_LT(calls, 100 * 40);
}

}  // namespace
}  // namespace cutwater::test
