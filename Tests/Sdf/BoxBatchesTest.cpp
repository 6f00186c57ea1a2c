#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <array>
#include <limits>
#include <vector>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BoxBatchesTest : public ::testing::Test {
 protected:
  /// More than one piece, and some boxes that are none.
  static std::vector<Box<T>> boxes(bool allAreFinite) {
    constexpr T kInf = Box<T>::kInf;
    RandomPoints<T> random(T(1.3), /*seed=*/3);
    std::vector<Box<T>> result;
    for (int i = 0; i < 700; ++i) {
      const auto center = random.next();
      const auto half = T(i % 3 == 0 ? 0.01 : 0.2) * abs(random.next());
      result.push_back({center - half, center + half});
    }
    if (!allAreFinite) {
      result[300] = {};
      result[301].upper.y = kInf;
      result[302].lower.z = std::numeric_limits<T>::quiet_NaN();
    }
    return result;
  }
  static Solid<T> placed() {
    Solid<T> solid = Torus<T>(1, T(0.3)) | Cuboid<T>({-1, 0, 0}, {0, 1, T(0.5)});
    solid.rotate(25, {1, 2, 3});
    solid.translate({T(0.1), T(-0.2), T(0.3)});
    return solid;
  }
};
TYPED_TEST_SUITE(BoxBatchesTest, Precisions);

TYPED_TEST(BoxBatchesTest, AreAnsweredAsOneByOne) {
  using T = TypeParam;
  const auto solid = this->placed();
  for (const bool allAreFinite : {true, false}) {
    const auto boxes = this->boxes(allAreFinite);
    std::vector<BoxClass> expected;
    std::array<int, 4> count{};
    for (const auto& box : boxes) {
      expected.push_back(solid.classify(box));
      ++count[static_cast<std::size_t>(expected.back())];
    }
    for (const auto kind : {BoxClass::Inside, BoxClass::Outside, BoxClass::Cut}) {
      EXPECT_GT(count[static_cast<std::size_t>(kind)], 20);
    }
    std::vector<BoxClass> found(boxes.size());
    solid.classify(std::span<const Box<T>>(boxes), std::span(found));
    EXPECT_EQ(found, expected);
    std::vector<BoxHint> hints(boxes.size());
    for (int round = 0; round < 2; ++round) {  // what was learned about a box holds for it
      std::ranges::fill(found, BoxClass::Unknown);
      solid.classify(std::span<const Box<T>>(boxes), std::span(found), std::span(hints));
      EXPECT_EQ(found, expected);
    }
    if (!allAreFinite) {
      for (const std::size_t i : {300U, 301U, 302U}) EXPECT_EQ(found[i], BoxClass::Unknown);
    }
  }
}

TYPED_TEST(BoxBatchesTest, MayBeEmpty) {
  using T = TypeParam;
  std::vector<BoxClass> found;
  Sphere<T>({0, 0, 0}, 1).classify(std::span<const Box<T>>{}, std::span(found));
  EXPECT_TRUE(found.empty());
}

TYPED_TEST(BoxBatchesTest, NeedOneClassPerBoxAndOneHintOrNone) {
  using T = TypeParam;
  const Sphere<T> sphere({0, 0, 0}, 1);
  const std::vector<Box<T>> boxes(3);
  std::vector<BoxClass> found(3);
  std::vector<BoxHint> hints(2);
  const std::span<const Box<T>> given(boxes);
  EXPECT_THROW(sphere.classify(given, std::span(found).first(2)), Error);
  EXPECT_THROW(sphere.classify(given, std::span(found), std::span(hints)), Error);
}

}  // namespace
}  // namespace cutwater::test
