#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <array>

namespace cutwater {

/// The nodes of an octree mesh: its cells' corners, each numbered once, including those where a
/// coarser neighbour has no corner (hanging nodes). A part of a mesh (one rank's cells) has the
/// nodes of its own cells.
///
/// Numbers below the number of cells() are the cells' lower corners, in the order of the cells;
/// then come the nodes that are no cell's lower corner. Takes 8 bytes for each cell and 8 for each
/// such node.
template <std::floating_point T>
class OctreeNodes {
 public:
  /// Nodes of a cell, in the order of Box::corner().
  using Corners = std::array<std::uint64_t, 8>;

  /// The mesh must outlive it. Between its first cell and its last, none may be missing.
  explicit OctreeNodes(const OctreeCells<T>& mesh, const ParallelOptions& options = {});

  /// Number of nodes.
  [[nodiscard]] std::size_t count() const { return places_.size() + others_.size(); }
  /// Index among the nodes of the finest level, mesh.deepest().
  [[nodiscard]] Index3 index(std::size_t node) const;
  /// Position of the node or index: the same for all levels, to the bit.
  [[nodiscard]] Vec3<T> position(std::size_t node) const { return position(index(node)); }
  [[nodiscard]] Vec3<T> position(const Index3& index) const { return level_.position(index); }

  /// Writes the nodes of consecutive cells from `firstCell` on, as many as the span has room for.
  /// This costs much less than one cell at a time.
  void corners(std::size_t firstCell, std::span<Corners> result) const;
  /// Writes the nodes of these cells; most efficient if they are in order.
  void corners(std::span<const std::size_t> cells, std::span<Corners> result) const;

 private:
  /// The place of a cell's corner.
  struct Place {
    Index3 node;
    std::uint64_t code = 0;   ///< Morton code; valid unless isBeyond
    bool isBeyond = false;    ///< past the last cell on an axis
    bool isInParent = false;  ///< a cell of the same parent begins there
  };

  /// Calls visit(corner, its place) for all corners of a cell except its lower one.
  template <typename Visit>
  void forCorners(std::size_t cell, const Visit& visit) const;
  /// Writes the nodes of `count` cells: cellAt(0), cellAt(1), ...
  template <typename CellAt>
  void corners(std::size_t count, const CellAt& cellAt, std::span<Corners> result) const;
  /// Returns the cell whose lower corner is there, or kNoCell. Searches from `near`, and sets it to
  /// the place found.
  [[nodiscard]] std::size_t cellFrom(const Place& place, std::size_t& near) const;

  static constexpr auto kNoCell = static_cast<std::size_t>(-1);

  const OctreeCells<T>& mesh_;
  Level<T> level_;
  Index3 size_;                        // cells of the finest level along each axis
  std::vector<std::uint64_t> places_;  // Morton codes of cells' lower corners, ascending
  std::vector<std::uint64_t> others_;  // keys of other nodes, ascending
};

extern template class OctreeNodes<float>;
extern template class OctreeNodes<double>;

}  // namespace cutwater
