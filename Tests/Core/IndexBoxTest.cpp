#include <Cutwater/Core/IndexBox.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(IndexBox, CountsBothEnds) {
  const IndexBox box{{-2, 0, 5}, {2, 0, 6}};
  EXPECT_EQ(box.length(0), 5U);
  EXPECT_EQ(box.length(1), 1U);
  EXPECT_EQ(box.length(2), 2U);
  EXPECT_EQ(box.count(), 10U);
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(IndexBox::ofSize(4, 3, 2), (IndexBox{{0, 0, 0}, {3, 2, 1}}));
}

TEST(IndexBox, IsEmptyIfOneAxisIs) {
  EXPECT_TRUE(IndexBox{}.empty());
  EXPECT_TRUE((IndexBox{{0, 0, 0}, {5, -3, 5}}.empty()));
  EXPECT_EQ((IndexBox{{0, 0, 0}, {5, -3, 5}}.length(1)), 0U);
  EXPECT_TRUE(IndexBox::ofSize(3, 0, 3).empty());
}

TEST(IndexBox, CountsAllThereAre) {
  constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ((IndexBox{{kLeast, 0, 0}, {kMost, 0, 0}}.count()), std::size_t{1} << 32U);
}

TEST(IndexBox, ContainsBothEnds) {
  const IndexBox box{{-2, 0, 5}, {2, 0, 6}};
  EXPECT_TRUE(box.contains({-2, 0, 5}));
  EXPECT_TRUE(box.contains({2, 0, 6}));
  for (const auto& index : {Index3{-3, 0, 5}, Index3{3, 0, 5}, Index3{0, -1, 5}, Index3{0, 1, 5},
                            Index3{0, 0, 4}, Index3{0, 0, 7}}) {
    EXPECT_FALSE(box.contains(index));
  }
  EXPECT_FALSE(IndexBox{}.contains({0, 0, 0}));
}

TEST(IndexBox, CountsStepsFromItsLowerEnd) {
  constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
  const IndexBox box{{-2, kLeast, 5}, {2, 0, 6}};
  EXPECT_EQ(box.at(0, 0, 0), box.lo);
  EXPECT_EQ(box.at(3, std::uint32_t{1} << 31U, 1), (Index3{1, 0, 6}));
}

}  // namespace
}  // namespace cutwater::test
