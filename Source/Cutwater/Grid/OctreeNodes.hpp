#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <array>

namespace cutwater {

/// The nodes of an octree mesh: its cells' corners, each numbered once. Where a coarser neighbour
/// has no corner (hanging nodes), they are nodes as well. A stretch of a mesh (one rank's cells)
/// has those of its own cells.
///
/// The numbers below that of cells() are the cells' lower corners, in the order of the cells; then
/// come those that no cell begins at. Takes 8 bytes for each cell and each of the latter.
template <std::floating_point T>
class OctreeNodes {
 public:
  /// Of a cell, in the order of Box::corner().
  using Corners = std::array<std::uint64_t, 8>;

  /// The mesh must outlive it. Between its first cell and its last, none may be missing.
  explicit OctreeNodes(const OctreeCells<T>& mesh, const ParallelOptions& options = {});

  /// How many nodes there are.
  [[nodiscard]] std::size_t count() const { return places_.size() + others_.size(); }
  /// Index among the nodes of the finest level, mesh.deepest().
  [[nodiscard]] Index3 index(std::size_t node) const;
  /// That of the index: for all levels the same, to the bit.
  [[nodiscard]] Vec3<T> position(std::size_t node) const { return position(index(node)); }
  [[nodiscard]] Vec3<T> position(const Index3& index) const { return level_.position(index); }

  /// Nodes of as many cells as the span has room for, from `firstCell` on. Cells in their order
  /// cost much less together than one by one.
  void corners(std::size_t firstCell, std::span<Corners> result) const;
  /// Of these cells, best in their order.
  void corners(std::span<const std::size_t> cells, std::span<Corners> result) const;

 private:
  /// Where a corner of a cell is.
  struct Place {
    Index3 node;
    MortonCode code = 0;      ///< unless it is past the last cell on an axis
    bool isBeyond = false;    ///< it is
    bool isInParent = false;  ///< a cell of the same parent begins there
  };

  /// Calls visit(corner, its place) for the corners of a cell but its lower one.
  template <typename Visit>
  void forCorners(std::size_t cell, const Visit& visit) const;
  /// Nodes of count > 0 cells: cellAt(0), cellAt(1), ...
  template <typename CellAt>
  void corners(std::size_t count, const CellAt& cellAt, std::span<Corners> result) const;
  /// The cell that begins there, or kNoCell; looks from `near` on, and leaves it where that was.
  [[nodiscard]] std::size_t cellFrom(const Place& place, std::size_t& near) const;

  static constexpr auto kNoCell = static_cast<std::size_t>(-1);

  const OctreeCells<T>& mesh_;
  Level<T> level_;
  Index3 size_;                        // cells of the finest level along each axis
  std::vector<MortonCode> places_;     // cells' lower corners, ascending
  std::vector<std::uint64_t> others_;  // keys of other nodes, ascending
};

extern template class OctreeNodes<float>;
extern template class OctreeNodes<double>;

}  // namespace cutwater
