#pragma once

#include <Cutwater/Grid/OctreeNodes.hpp>

#include <atomic>
#include <mutex>

namespace cutwater::detail {

/// An edge of a cell: from one corner, see Box::corner(), along an axis to another.
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

/// The part of an edge between two crossings.
template <std::floating_point T>
struct EdgeStretch {
  Vec3<T> middle;
  T distance;  ///< the value at the middle, not 0
};

/// Returns nothing if the middle is not on the side that the first crossing leads to: where the
/// edge only touches the surface, or runs along it, the crossings coincide up to round-off.
template <std::floating_point T>
[[nodiscard]] std::optional<EdgeStretch<T>> stretchBetween(const SignedDistanceFunction<T>& solid,
                                                           const Segment<T>& edge,
                                                           const Crossing<T>& first,
                                                           const Crossing<T>& second) {
  const auto middle = edge.at((first.parameter + second.parameter) / 2);
  const T distance = solid.signedDistance(middle);
  if (distance == 0 || (distance < 0) != first.entering) return {};
  return EdgeStretch<T>{middle, distance};
}

/// What is known about the surface at the corners and edges of a cell.
template <std::floating_point T>
struct CellSigns {
  unsigned inside = 0;  ///< a bit for each corner with a negative value
  /// For each of kCellEdges: 0 if there is no crossing, 1 if its ends are on different sides, 2 if
  /// it also passes through something between crossings.
  std::array<std::uint8_t, 12> crossings{};
  /// Of the stretches between crossings of one edge, the one whose middle is farthest from the
  /// surface; of distance 0 if there is none.
  EdgeStretch<T> thickest{};

  [[nodiscard]] bool isInside(int corner) const { return (inside >> corner & 1U) != 0; }
};

/// Signs at the corners of those cells of an octree mesh that the surface may meet, and how often
/// it crosses their edges. Each corner and edge is queried once, however many cells share it.
template <std::floating_point T>
class OctreeSigns {
 public:
  /// Evaluates the solid at all corners. Solid and mesh must outlive this object.
  OctreeSigns(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
              const ParallelOptions& options);

  /// Cells of a level that the surface may meet: their indices in mesh.cells(), ascending.
  [[nodiscard]] std::span<const std::size_t> cells(int level) const {
    return cells_[static_cast<std::size_t>(level)];
  }
  /// Queries the edges of cells(level), and forgets those of other levels.
  void countCrossings(int level, const ParallelOptions& options);
  /// Writes the signs of some of these cells.
  void signs(std::span<const std::size_t> cells, std::span<CellSigns<T>> result) const;

  /// Number of cells that are best queried together.
  static constexpr std::size_t kMost = 64;

 private:
  /// What remains to be done for an edge; later its value in CellSigns::crossings.
  using Mark = std::uint8_t;
  static constexpr Mark kFree = 0;
  static constexpr Mark kToClassify = 1;  ///< its ends are on one side
  static constexpr Mark kCrossed = 2;

  /// Calls visit(corners of a cell) for each of the cells, in parallel.
  template <typename Visit>
  void forCells(std::span<const std::size_t> cells, const ParallelOptions& options,
                const Visit& visit) const;
  void evaluate(const ParallelOptions& options);
  void markEdges(int level, const ParallelOptions& options);
  /// Queries some edges, given by their numbers.
  void countCrossingsOf(int level, std::span<const std::size_t> edges);
  /// See CellSigns. `thickest`: of this edge.
  [[nodiscard]] Mark countOf(const Segment<T>& edge, std::span<const Crossing<T>> crossings,
                             EdgeStretch<T>& thickest) const;
  /// What is known of an edge that is crossed more than once.
  [[nodiscard]] const EdgeStretch<T>& thickestOf(std::size_t edge) const;
  [[nodiscard]] Segment<T> edge(std::size_t number, int level) const;
  [[nodiscard]] bool isInside(std::size_t node) const { return values_[node] < 0; }
  /// Number of the edge that begins at a node.
  [[nodiscard]] static std::size_t edgeNumber(std::uint64_t node, int axis) {
    return 3 * node + static_cast<std::size_t>(axis);
  }

  const SignedDistanceFunction<T>& solid_;
  const OctreeCells<T>& mesh_;
  OctreeNodes<T> nodes_;
  std::vector<std::vector<std::size_t>> cells_;  // of each level
  std::vector<T> values_;                        // at all nodes; 0 where not needed
  std::vector<std::atomic<Mark>> edges_;         // by their numbers
  struct NumberedStretch {
    std::size_t edge;
    EdgeStretch<T> thickest;
  };
  std::vector<NumberedStretch> stretches_;  // of edges that are crossed more than once; ascending
  std::mutex stretchesMutex_;               // while they are being found
};

extern template class OctreeSigns<float>;
extern template class OctreeSigns<double>;

}  // namespace cutwater::detail
