#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/P4est/Detail/GhostLeaves.hpp>

#include <algorithm>
#include <memory>

#include <p8est_ghost.h>

namespace cutwater::detail {

namespace {

using Ghosts = std::unique_ptr<p8est_ghost_t, decltype(&p8est_ghost_destroy)>;

/// Which of the fine leaves across a face of a coarse one is where is known from all of them. They
/// touch one another in edges, so one layer will do if it has those that touch in edges, two
/// otherwise. p4est makes layers only across what the forest is balanced across.
Ghosts ghostsOf(p8est_t& forest, Balance balance) {
  const auto across = balance == Balance::Face   ? P8EST_CONNECT_FACE
                      : balance == Balance::Edge ? P8EST_CONNECT_EDGE
                                                 : P8EST_CONNECT_FULL;
  Ghosts ghosts(p8est_ghost_new(&forest, across), p8est_ghost_destroy);
  if (balance == Balance::Face) p8est_ghost_expand(&forest, ghosts.get());
  return ghosts;
}

}  // namespace

Index3 rootOf(const p8est_t& forest, p4est_topidx_t tree) {
  // A brick's vertices have integer coordinates; the first vertex of a tree is its lower corner.
  const auto& brick = *forest.connectivity;
  const std::ptrdiff_t vertex = brick.tree_to_vertex[std::ptrdiff_t{P8EST_CHILDREN} * tree];
  const double* lower = brick.vertices + 3 * vertex;
  return {static_cast<std::int32_t>(lower[0]), static_cast<std::int32_t>(lower[1]),
          static_cast<std::int32_t>(lower[2])};
}

Index3 indexIn(const Index3& root, const p8est_quadrant_t& quadrant) {
  const auto along = [&](std::int32_t first, p4est_qcoord_t x) {
    return (first << quadrant.level) + (x >> (P8EST_MAXLEVEL - quadrant.level));
  };
  return {along(root.i, quadrant.x), along(root.j, quadrant.y), along(root.k, quadrant.z)};
}

LeavesWithGhosts leavesWithGhosts(p8est_t& forest, Balance balance,
                                  std::span<const OctreeCell> own) {
  const auto ghosts = ghostsOf(forest, balance);
  std::vector<std::pair<std::uint64_t, OctreeCell>> leaves;
  const auto firstOf = [&](int rank) {
    return static_cast<std::uint64_t>(forest.global_first_quadrant[rank]);
  };
  for (int rank = 0; rank < forest.mpisize; ++rank) {
    for (auto n = ghosts->proc_offsets[rank]; n < ghosts->proc_offsets[rank + 1]; ++n) {
      const auto& ghost = *p8est_quadrant_array_index(&ghosts->ghosts, static_cast<std::size_t>(n));
      const auto& [tree, number] = ghost.p.piggy3;
      leaves.emplace_back(firstOf(rank) + static_cast<std::uint64_t>(number),
                          OctreeCell{.index = indexIn(rootOf(forest, tree), ghost),
                                     .level = static_cast<std::uint8_t>(ghost.level)});
    }
  }
  for (std::size_t n = 0; n < own.size(); ++n) {
    leaves.emplace_back(firstOf(forest.mpirank) + n, own[n]);
  }
  std::ranges::sort(leaves, {}, [](const auto& leaf) { return leaf.first; });
  LeavesWithGhosts result;
  for (const auto& [number, cell] : leaves) {
    if (number < firstOf(forest.mpirank)) ++result.firstOwn;
    result.numbers.push_back(number);
    result.cells.push_back(cell);
  }
  return result;
}

}  // namespace cutwater::detail
