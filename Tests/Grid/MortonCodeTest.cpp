#include <Cutwater/Grid/Detail/MortonCode.hpp>

#include <random>

#include <gtest/gtest.h>

namespace cutwater::detail::test {
namespace {

TEST(MortonCodeTest, TakesBitsInTurns) {
  EXPECT_EQ(mortonCode({1, 0, 0}), 1U);
  EXPECT_EQ(mortonCode({0, 1, 0}), 2U);
  EXPECT_EQ(mortonCode({0, 0, 1}), 4U);
  EXPECT_EQ(mortonCode({3, 0, 2}), 0b101001U);
  constexpr std::int32_t kLast = (1 << kMortonBits) - 1;
  EXPECT_EQ(mortonCode({kLast, kLast, kLast}), (std::uint64_t{1} << 63U) - 1);
}

TEST(MortonCodeTest, IsInvertedByIndexOf) {
  std::mt19937 engine(1);
  std::uniform_int_distribution<std::int32_t> coordinate(0, (1 << kMortonBits) - 1);
  for (int i = 0; i < 1000; ++i) {
    const Index3 index{coordinate(engine), coordinate(engine), coordinate(engine)};
    ASSERT_EQ(indexOf(mortonCode(index)), index);
  }
}

TEST(MortonCodeTest, ChildrenFollowEachOther) {
  const Index3 cell{5, 9, 2};
  for (int child = 0; child < 8; ++child) {
    const Index3 index{10 + (child & 1), 18 + (child >> 1 & 1), 4 + (child >> 2)};
    EXPECT_EQ(mortonCode(index), 8 * mortonCode(cell) + static_cast<unsigned>(child));
  }
}

}  // namespace
}  // namespace cutwater::detail::test
