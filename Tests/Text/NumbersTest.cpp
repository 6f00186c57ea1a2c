#include <Cutwater/Text/Numbers.hpp>

#include <gtest/gtest.h>

namespace cutwater::text {
namespace {

TEST(NumbersTest, DigitsAreGroupedByThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1 000");
  EXPECT_EQ(grouped(1234567), "1 234 567");
}

TEST(NumbersTest, CountsAreWords) {
  EXPECT_EQ(counted(0, "face", "faces"), "0 faces");
  EXPECT_EQ(counted(1, "face", "faces"), "1 face");
  EXPECT_EQ(counted(4'000'000'000, "vertex", "vertices"), "4000000000 vertices");
}

TEST(NumbersTest, NounsFollowTheCount) {
  EXPECT_EQ(grouped(1, "hole"), "1 hole");
  EXPECT_EQ(grouped(0, "hole"), "0 holes");
  EXPECT_EQ(grouped(1234, "hole"), "1 234 holes");
  EXPECT_EQ(grouped(1, "patch"), "1 patch");
  EXPECT_EQ(grouped(3, "patch"), "3 patches");
}

TEST(NumbersTest, NumbersHaveTheDigitsAskedFor) {
  EXPECT_EQ(number(6.27314159), "6.27314");
  EXPECT_EQ(number(1.5e-5), "1.5e-05");
  EXPECT_EQ(number(2.0 / 3, 2), "0.67");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(exactly(0.1), "0.1");
  EXPECT_EQ(exactly(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(exactly(-0.0), "0");
  EXPECT_EQ(rounded(0.1 + 0.2, 6), 0.3);
  EXPECT_EQ(rounded(1234.5, 1), 1000);
}

TEST(NumbersTest, PointsAndLists) {
  EXPECT_EQ(point({1, 2.5, -3}), "(1, 2.5, -3)");
  EXPECT_EQ(point({1.0 / 3, 0, 0}, 2), "(0.33, 0, 0)");
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
}

}  // namespace
}  // namespace cutwater::text
