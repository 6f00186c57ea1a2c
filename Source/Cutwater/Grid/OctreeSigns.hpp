#pragma once

#include <Cutwater/Grid/OctreeNodes.hpp>

#include <atomic>

namespace cutwater::detail {

/// An edge of a cell: from a corner, see Box::corner(), along an axis to another.
struct CellEdge {
  int from;
  int axis;

  [[nodiscard]] constexpr int to() const { return from | 1 << axis; }
};

/// All edges of a cell, axis by axis.
inline constexpr std::array<CellEdge, 12> kCellEdges{{{0, 0},
                                                      {2, 0},
                                                      {4, 0},
                                                      {6, 0},
                                                      {0, 1},
                                                      {1, 1},
                                                      {4, 1},
                                                      {5, 1},
                                                      {0, 2},
                                                      {1, 2},
                                                      {2, 2},
                                                      {3, 2}}};

/// What corners and edges of a cell tell of the surface.
struct CellSigns {
  unsigned inside = 0;                       ///< a bit for each corner with a negative value
  std::array<std::uint8_t, 12> crossings{};  ///< of kCellEdges: none, one, or 2 for more

  [[nodiscard]] bool isInside(int corner) const { return (inside >> corner & 1U) != 0; }
};

/// Signs at the corners of those cells of an octree mesh that the surface may meet, and how often
/// it crosses their edges. Corners and edges are asked about once, however many cells share them.
template <std::floating_point T>
class OctreeSigns {
 public:
  /// Values at all corners. Solid and mesh must outlive it.
  OctreeSigns(const SignedDistanceFunction<T>& solid, const Octree<T>& mesh,
              const ParallelOptions& options);

  /// Cells of a level that the surface may meet: their places in cells(), ascending.
  [[nodiscard]] std::span<const std::size_t> cells(int level) const {
    return cells_[static_cast<std::size_t>(level)];
  }
  /// Asks about the edges of cells(level); nothing is known of those of other levels any more.
  void askEdges(int level, const ParallelOptions& options);
  /// Of some of these cells.
  void signs(std::span<const std::size_t> cells, std::span<CellSigns> result) const;

  /// Cells that are best asked about together.
  static constexpr std::size_t kMost = 64;

 private:
  /// What is to be done about an edge; later the number of crossings, see CellSigns.
  using Mark = std::uint8_t;
  static constexpr Mark kFree = 0;
  static constexpr Mark kToClassify = 1;  ///< its ends are on one side
  static constexpr Mark kCrossed = 2;

  /// Calls visit(corners of a cell) for each of the cells, in parallel.
  template <typename Visit>
  void forCells(std::span<const std::size_t> cells, ParallelOptions options,
                const Visit& visit) const;
  void evaluate(const ParallelOptions& options);
  void markEdges(int level, const ParallelOptions& options);
  /// Counts crossings of some edges by their numbers.
  void count(int level, std::span<const std::size_t> edges);
  [[nodiscard]] Segment<T> edge(std::size_t number, int level) const;
  [[nodiscard]] bool isInside(std::size_t node) const { return values_[node] < 0; }
  /// Of the edge that begins at a node.
  [[nodiscard]] static std::size_t edgeNumber(std::uint64_t node, int axis) {
    return 3 * node + static_cast<std::size_t>(axis);
  }

  const SignedDistanceFunction<T>& solid_;
  const Octree<T>& mesh_;
  OctreeNodes<T> nodes_;
  std::vector<std::vector<std::size_t>> cells_;  // of each level
  std::vector<T> values_;                        // of all nodes; 0 of those that are no corners
  std::vector<std::atomic<Mark>> edges_;         // by their numbers
};

extern template class OctreeSigns<float>;
extern template class OctreeSigns<double>;

}  // namespace cutwater::detail
