#include <Cutwater/Mesh/Detail/ClippedSegment.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

const Box<double> kBox{{-2, -2, -2}, {2, 2, 2}};

TEST(ClippedSegmentTest, KeepsWhatIsWithin) {
  const auto whole = clipped({{-1, 0, 2}, {1, 1, 0}}, kBox);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->part.start, (Vec3<double>{-1, 0, 2}));
  EXPECT_EQ(whole->part.end, (Vec3<double>{1, 1, 0}));
  EXPECT_EQ(whole->start, 0);
  EXPECT_EQ(whole->end, 1);

  const auto half = clipped({{1, 1, 0}, {1, 5, 4}}, kBox);
  ASSERT_TRUE(half);
  EXPECT_EQ(half->part.start, (Vec3<double>{1, 1, 0}));
  EXPECT_EQ(half->part.end, (Vec3<double>{1, 2, 1}));
  EXPECT_EQ(half->start, 0);
  EXPECT_EQ(half->end, 0.25);
}

TEST(ClippedSegmentTest, PassesByOrEndsBefore) {
  EXPECT_FALSE(clipped({{-9, 3, 0}, {9, 3, 0}}, kBox));
  EXPECT_FALSE(clipped({{3, 0, 0}, {9, 0, 0}}, kBox));
  EXPECT_FALSE(clipped({{5, 0, 0}, {0, 5, 0}}, kBox));
}

TEST(ClippedSegmentTest, StaysOnTheLineHoweverFarItsEndsAre) {
  for (const int exponent : {3, 60, 300, 1023}) {
    const double far = std::ldexp(1.0, exponent);
    const auto slanted = clipped({{far, -far, 0.3}, {-far, far, 0.3}}, kBox);
    ASSERT_TRUE(slanted);
    EXPECT_EQ(slanted->part.start, (Vec3<double>{2, -2, 0.3}));
    EXPECT_EQ(slanted->part.end, (Vec3<double>{-2, 2, 0.3}));
    EXPECT_NEAR(slanted->start, 0.5 - 1 / far, 1e-16);
    EXPECT_LE(slanted->start, slanted->end);
  }
}

}  // namespace
}  // namespace cutwater::test
