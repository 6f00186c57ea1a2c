#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Core/Level.hpp>

#include <vector>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class LevelTest : public ::testing::Test {};
TYPED_TEST_SUITE(LevelTest, Precisions);

TYPED_TEST(LevelTest, PositionsFollowFromTheGlobalIndex) {
  using T = TypeParam;
  const Level<T> cells({10, 20, 30}, {1, 2, 4});
  EXPECT_EQ(cells.position({0, 0, 0}), (Vec3<T>{T(10.5), 21, 32}));
  EXPECT_EQ(cells.position({-1, 3, 2}), (Vec3<T>{T(9.5), 27, 40}));
  EXPECT_EQ(cells.cell({0, 0, 0}), (Box<T>{{10, 20, 30}, {11, 22, 34}}));
  EXPECT_EQ(cells.smallestSpacing(), T(1));
  const Level<T> nodes({10, 20, 30}, {1, 2, 4}, Centering::Node);
  EXPECT_EQ(nodes.position({0, 0, 0}), (Vec3<T>{10, 20, 30}));
  EXPECT_EQ(nodes.cell({0, 0, 0}), (Box<T>{{T(9.5), 19, 28}, {T(10.5), 21, 32}}));
}

TYPED_TEST(LevelTest, PatchesAgreeToTheBit) {
  using T = TypeParam;
  const Level<T> level({T(0.1), T(-0.3), T(7.7)}, {T(0.1), T(0.7), T(0.3)});
  const GridPatch<T> left{level, {{-3, 0, 0}, {5, 1, 1}}};
  const GridPatch<T> right{level, {{4, 0, 0}, {9, 1, 1}}};
  for (std::int32_t i = right.indices.lo.i; i <= left.indices.hi.i; ++i) {
    // Each patch arrives at the index on its own way.
    const auto fromLeft = static_cast<std::int32_t>(left.indices.lo.i + (i - left.indices.lo.i));
    EXPECT_EQ(left.level.position({fromLeft, 1, 0}), right.level.position({i, 1, 0}));
    EXPECT_EQ(level.cell({i, 0, 0}).upper.x, level.cell({i + 1, 0, 0}).lower.x);
  }
  // Not accumulated: the thousandth position is one rounding away from the exact one.
  EXPECT_NEAR(level.position({1000, 0, 0}).x, double(T(0.1)) + 1000.5 * double(T(0.1)),
              tolerance<T>(100, 1));
}

// Beyond 2^24, or 2^23 with halves, not every index has a float of its own.
TYPED_TEST(LevelTest, CellsOfTheHighestIndicesAgreeOnTheirFaces) {
  using T = TypeParam;
  for (const auto centering : {Centering::Cell, Centering::Node}) {
    const Level<T> level({T(-16777.216), 0, 0}, {T(1e-3), 1, 1}, centering);
    for (const std::int32_t first : {8388607, 16777215, 2147483000}) {
      for (std::int32_t i = first; i < first + 9; ++i) {
        EXPECT_EQ(level.cell({i, 0, 0}).upper.x, level.cell({i + 1, 0, 0}).lower.x) << i;
      }
    }
  }
}

TYPED_TEST(LevelTest, RefusesImpossibleSpacings) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW(Level<T>({0, 0, 0}, {1, 0, 1}), Error);
  EXPECT_THROW(Level<T>({0, 0, 0}, {1, -1, 1}), Error);
  EXPECT_THROW(Level<T>({0, nan, 0}, {1, 1, 1}), Error);
  EXPECT_THROW(Level<T>({0, 0, 0}, {1, nan, 1}), Error);
}

TEST(IndexBox, CountsInclusively) {
  EXPECT_TRUE(IndexBox{}.empty());
  const IndexBox box{{-1, 2, 3}, {1, 2, 6}};
  EXPECT_EQ(box.length(0), 3U);
  EXPECT_EQ(box.length(1), 1U);
  EXPECT_EQ(box.count(), 12U);
  EXPECT_EQ(IndexBox::ofSize(4, 5, 6).count(), 120U);
  EXPECT_EQ((IndexBox{{0, 0, 0}, {3, -5, 3}}).count(), 0U);
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ((IndexBox{{-most - 1, 0, 0}, {most, 0, 0}}).length(0), std::size_t{1} << 32U);
}

TEST(GridView, AddressesAnyLayout) {
  const auto box = IndexBox::ofSize(3, 4, 5);
  std::vector<int> values(box.count() * 2, 0);
  const auto plain = GridView<int>::contiguous(values.data(), box);
  EXPECT_EQ(&plain.at(1, 2, 3), &values[1 + 3 * (2 + 4 * 3)]);
  // The second of two components, z fastest.
  const GridView<int> strided{values.data() + 1, {2 * 5 * 4, 2 * 5, 2}};
  strided.at(2, 3, 4) = 7;
  EXPECT_EQ(values.back(), 7);
  EXPECT_EQ(&strided.at(0, 0, 0), &values[1]);
}

}  // namespace
}  // namespace cutwater::test
