#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PolygonSoup triangle() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.addPolygon(std::array{0U, 1U, 2U});
  return soup;
}

TEST(PolygonSoupTest, WeldsEqualPointsInOrderOfAppearance) {
  PolygonSoup soup;
  soup.points = {{2, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}, {-0.0, 0, 1}, {0, -0.0, 1}, {1, 0, 0}};
  soup.addPolygon(std::array{2U, 6U, 5U});
  EXPECT_EQ(weldExactly(soup), 3U);
  ASSERT_EQ(soup.points.size(), 4U);
  EXPECT_EQ(soup.points[0], Vec3<double>(2, 0, 0));
  EXPECT_EQ(soup.points[1], Vec3<double>(1, 0, 0));
  EXPECT_EQ(soup.points[2], Vec3<double>(9, 9, 9)) << "unused points stay";
  EXPECT_EQ(soup.points[3], Vec3<double>(0, 0, 1));
  EXPECT_TRUE(std::signbit(soup.points[3].x)) << "zero keeps the sign of its first appearance";
  EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(weldExactly(soup), 0U);
}

TEST(PolygonSoupTest, WeldsOnlyWhatIsExactlyEqual) {
  PolygonSoup soup;
  soup.points = {{1, 1, 1}, {1, 1, std::nextafter(1.0, 2.0)}, {kNan, 0, 0}, {kNan, 0, 0}};
  EXPECT_EQ(weldExactly(soup), 0U);
}

// Coordinates of a regular grid differ in few bits: a weak hash would make this quadratic.
TEST(PolygonSoupTest, WeldsLargeGridsInLinearTime) {
  PolygonSoup soup;
  constexpr int kSide = 60;
  for (int copy = 0; copy < 2; ++copy) {
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      soup.points.push_back(
          {1024.0 * (i % kSide), 0.5 * (i / kSide % kSide), 1e-3 * (i / kSide / kSide)});
    }
  }
  EXPECT_EQ(weldExactly(soup), std::size_t{kSide} * kSide * kSide);
}

TEST(PolygonSoupTest, ItsBoxIsThatOfTheSurface) {
  auto soup = triangle();
  soup.points.emplace_back(1e9, 0, kNan);  // no corner of a face
  EXPECT_EQ(soup.boundingBox(), (Box<double>{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_TRUE(PolygonSoup{}.boundingBox().empty());
}

TEST(PolygonSoupTest, ValidatesSoupsMadeByHand) {
  EXPECT_NO_THROW(triangle().validate());
  auto soup = triangle();
  soup.corners[1] = 3;
  EXPECT_THROW(soup.validate(), Error);
  soup = triangle();
  soup.points[1].y = kNan;
  EXPECT_THROW(soup.validate(), Error);
  soup = triangle();
  soup.offsets.push_back(3);
  EXPECT_THROW(soup.validate(), Error);
  soup = triangle();
  soup.offsets = {0, 2};
  EXPECT_THROW(soup.validate(), Error);
  soup = triangle();
  soup.addPolygon(std::array{0U, 1U});
  EXPECT_THROW(soup.validate(), Error);
  soup = triangle();
  soup.addPolygon(std::array{0U, 1U, 2U});
  soup.offsets = {0, ~std::uint64_t{0}, 6};
  EXPECT_THROW(soup.validate(), Error);
}

// Cut off to 32 bits, these would be in range.
TEST(PolygonSoupTest, OffsetsCountInSixtyFourBits) {
  constexpr std::uint64_t kMuch = std::uint64_t{1} << 32U;
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.corners = {0, 1, 2, 0, 1, 2};
  soup.patches = {0, 0};
  soup.patchNames = {"a"};
  soup.offsets = {0, 3, 6};
  EXPECT_NO_THROW(soup.validate());
  for (const auto& offsets : std::vector<std::vector<std::uint64_t>>{
           {0, 3, kMuch + 6}, {0, kMuch + 3, 6}, {kMuch, 3, 6}, {0, UINT64_MAX - 2, 6}}) {
    soup.offsets = offsets;
    EXPECT_THROW(soup.validate(), Error);
    EXPECT_THROW(DcelMesh<double>{soup}, Error);
  }
}

}  // namespace
}  // namespace cutwater::test
