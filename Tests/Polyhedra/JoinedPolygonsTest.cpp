#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

bool always(std::size_t, std::size_t) {
  return true;
}

/// The cells of a grid of squares, whose nodes are numbered row by row.
std::vector<CornerLoop> squares(std::uint32_t columns, std::uint32_t rows) {
  std::vector<CornerLoop> result;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const auto corner = j * (columns + 1) + i;
      result.push_back({corner, corner + 1, corner + columns + 2, corner + columns + 1});
    }
  }
  return result;
}

TEST(JoinedPolygonsTest, ASheetHasOneRim) {
  const auto rims = joinedPolygons(squares(4, 3), always);
  ASSERT_EQ(rims.size(), 1U);
  EXPECT_EQ(rims.front().size(), 14U);
}

TEST(JoinedPolygonsTest, ARingHasMoreThanOne) {
  auto ring = squares(3, 3);
  ring.erase(ring.begin() + 4);
  const auto rims = joinedPolygons(ring, always);
  EXPECT_EQ(rims.size(), 2U);
}

TEST(JoinedPolygonsTest, WhatMeetsInACornerStaysApart) {
  auto two = squares(2, 2);
  two = {two[0], two[3]};
  EXPECT_EQ(joinedPolygons(two, always), two);
}

TEST(JoinedPolygonsTest, OneThatHasACornerTwiceStaysAlone) {
  const CornerLoop twice{1, 6, 7, 1, 8, 2};  // shares the edge from 1 to 2 with the square
  const CornerLoop square{0, 1, 2, 3};
  const auto rims = joinedPolygons({square, twice}, always);
  EXPECT_EQ(rims.size(), 2U);
  EXPECT_EQ(std::ranges::count(rims, twice), 1);
}

TEST(JoinedPolygonsTest, AClosedSurfaceKeepsItsLastPolygon) {
  const std::vector<CornerLoop> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(joinedPolygons(tetrahedron, always).size(), 2U);
}

TEST(JoinedPolygonsTest, OnlyThoseThatMayJoin) {
  const auto rims =
      joinedPolygons(squares(4, 1), [](std::size_t a, std::size_t b) { return a / 2 == b / 2; });
  EXPECT_EQ(rims.size(), 2U);
}

}  // namespace
}  // namespace cutwater::test
