#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace cutwater::detail::test {
namespace {

using Spacing = std::array<double, 3>;
using Lengths = std::array<std::size_t, 3>;

constexpr Lengths kLong{1000, 1000, 1000};

std::uint32_t points(const Offset& shape) {
  return shape[0] * shape[1] * shape[2];
}

/// Every aligned run of 2^n numbers is a box of the promised shape, without gaps.
void expectBoxes(const TileOrder& order) {
  for (int bits = 0; bits <= order.bits(); ++bits) {
    SCOPED_TRACE(bits);
    const auto shape = order.shape(bits);
    ASSERT_EQ(points(shape), 1U << bits);
    for (std::uint32_t begin = 0; begin < 1U << order.bits(); begin += 1U << bits) {
      const auto first = order.offset(begin);
      std::set<Offset> seen;
      for (std::uint32_t n = begin; n < begin + (1U << bits); ++n) {
        const auto offset = order.offset(n);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ASSERT_GE(offset[axis], first[axis]);
          ASSERT_LT(offset[axis], first[axis] + shape[axis]);
        }
        seen.insert(offset);
      }
      ASSERT_EQ(seen.size(), 1U << bits);
    }
  }
}

TEST(TileOrderTest, NumbersBoxes) {
  for (const Spacing& spacing : {Spacing{1, 1, 1}, Spacing{7, 1, 1}, Spacing{1, 3, 0.1}}) {
    for (const int bits : {9, 12}) expectBoxes({spacing, kLong, bits});
  }
  expectBoxes({{1, 1, 1}, {5, 1, 3}, 12});
  expectBoxes({{1, 1, 1}, {1, 1, 1}, 12});
}

TEST(TileOrderTest, BoxesAreAsLongOnEachAxisAsCanBe) {
  EXPECT_EQ(TileOrder({1, 1, 1}, kLong, 9).shape(9), (Offset{8, 8, 8}));
  EXPECT_EQ(TileOrder({1, 1, 1}, kLong, 9).shape(6), (Offset{4, 4, 4}));
  EXPECT_EQ(TileOrder({8, 1, 1}, kLong, 9).shape(9), (Offset{2, 16, 16}));
  for (const Spacing& spacing : {Spacing{7, 1, 1}, Spacing{1, 3, 0.1}, Spacing{5, 4, 9}}) {
    const TileOrder order(spacing, kLong, 12);
    for (int bits = 6; bits <= 12; ++bits) {
      const auto& shape = order.shape(bits);
      // A longer one could have been halved, and a shorter one doubled.
      std::array<double, 3> lengths{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (shape[axis] > 1) lengths[axis] = shape[axis] * spacing[axis];
      }
      const double longest = std::ranges::max(lengths);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_GE(2 * shape[axis] * spacing[axis], longest / 2) << bits;
      }
    }
  }
}

TEST(TileOrderTest, IsNotLongerThanNeededNorThanItMayBe) {
  const TileOrder flat({1, 1, 1}, {1000, 1000, 1}, 12);
  EXPECT_EQ(flat.shape(flat.bits()), (Offset{64, 64, 1}));
  const TileOrder small({1, 1, 1}, {3, 5, 2}, 12);
  EXPECT_EQ(small.shape(small.bits()), (Offset{4, 8, 2}));
  const TileOrder line({1, 1, 1}, {1, 1000, 1}, 9);
  EXPECT_EQ(line.shape(line.bits()), (Offset{1, TileOrder::kLongest, 1}));
  const TileOrder thin({1, 1, 1e-9}, kLong, 12);
  EXPECT_EQ(thin.shape(12)[2], TileOrder::kLongest);
}

/// Every index is in exactly one tile, and tiles are cut off at the upper ends only.
TEST(GridTilesTest, CoverTheGridPatchOnce) {
  const Offset shape{8, 8, 4};
  for (const IndexBox& indices : {IndexBox{{-3, 5, 0}, {16, 12, 8}}, IndexBox::ofSize(1, 1, 1),
                                  IndexBox::ofSize(16, 8, 4), IndexBox::ofSize(9, 7, 5)}) {
    const GridTiles tiles(indices, shape);
    std::set<Offset> seen;
    for (std::size_t number = 0; number < tiles.count(); ++number) {
      const auto [first, size] = tiles.tile(number);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto left = indices.length(static_cast<int>(axis)) - first[axis];
        ASSERT_EQ(first[axis] % shape[axis], 0U);
        ASSERT_EQ(size[axis], std::min<std::size_t>(shape[axis], left));
      }
      ASSERT_TRUE(seen.insert(first).second);
    }
    std::size_t covered = 0;
    for (std::size_t number = 0; number < tiles.count(); ++number) {
      covered += points(tiles.tile(number).size);
    }
    EXPECT_EQ(covered, indices.count());
  }
}

TEST(GridTilesTest, AreNumberedAlongXFirst) {
  const GridTiles tiles(IndexBox::ofSize(20, 9, 5), {8, 8, 4});
  EXPECT_EQ(tiles.count(), 3U * 2 * 2);
  EXPECT_EQ(tiles.tile(1).first, (Offset{8, 0, 0}));
  EXPECT_EQ(tiles.tile(3).first, (Offset{0, 8, 0}));
  EXPECT_EQ(tiles.tile(11).first, (Offset{16, 8, 4}));
  EXPECT_EQ(tiles.tile(11).size, (Offset{4, 1, 1}));
  EXPECT_EQ(GridTiles(IndexBox{}, {8, 8, 4}).count(), 0U);
}

}  // namespace
}  // namespace cutwater::detail::test
