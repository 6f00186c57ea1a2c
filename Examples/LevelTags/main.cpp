// Which cells of a block-structured mesh are to be refined: what a code such as AMReX or Chombo
// asks of every patch of every level, on every rank. See README.md.
#include <Cutwater/Grid/Tag.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace cutwater;

int main() {
  // A wing on a strut; the wing is a tenth as thick as a cell of the coarsest level.
  const Solid<double> wing = Cuboid<double>({-0.5, -0.8, 0.19}, {0.5, 0.8, 0.2});
  const Solid<double> solid = wing | Capsule<double>({0, 0, -1}, {0, 0, 0.2}, 0.05);

  // Surface cells to level 3, and what is within 0.2 of it to level 1.
  const Refinement<double> rules{.cut = 3, .bands = {{.distance = 0.2, .level = 1}}};

  // Level 0 is 20 x 20 x 20 cells, in patches of 10: each knows its own part of the level only.
  const Level<double> level({-1, -1, -1}, {0.1, 0.1, 0.1});
  std::size_t marked = 0;
  for (int n = 0; n < 8; ++n) {
    const Index3 lo{10 * (n & 1), 10 * (n >> 1 & 1), 10 * (n >> 2)};
    const IndexBox patch{lo, {lo.i + 9, lo.j + 9, lo.k + 9}};
    std::vector<std::uint8_t> tags(patch.count());
    tag(rules, solid, {level, patch}, 0, GridView<std::uint8_t>::contiguous(tags.data(), patch));
    marked += static_cast<std::size_t>(std::ranges::count(tags, 1));
  }

  // The same as in one piece.
  const auto whole = IndexBox::ofSize(20, 20, 20);
  std::vector<std::uint8_t> tags(whole.count());
  tag(rules, solid, {level, whole}, 0, GridView<std::uint8_t>::contiguous(tags.data(), whole));
  const auto all = static_cast<std::size_t>(std::ranges::count(tags, 1));
  std::printf("%zu of %zu cells are to be refined, in patches %zu\n", all, whole.count(), marked);

  // No corner of a cell of level 0 is inside the wing, and it is found all the same.
  const std::size_t inWing = 2 + 20 * (10 + 20 * 12);  // its box: x, y from -0.8, 0; z from 0.2
  return marked == all && tags[inWing + 4] == 1 ? 0 : 1;
}
