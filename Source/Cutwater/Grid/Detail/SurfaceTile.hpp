#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Grid/Detail/CellPolygons.hpp>
#include <Cutwater/Grid/Detail/SignChanges.hpp>

#include <vector>

namespace cutwater::detail {

/// A node, given by its offset from the first node of the grid or of a tile.
using NodeOffset = std::array<std::uint32_t, 3>;

/// A corner, as numbered in CellPolygons, of the cell whose lowest node is `cell`.
[[nodiscard]] inline NodeOffset cornerOf(const NodeOffset& cell, int corner) {
  return {cell[0] + static_cast<std::uint32_t>(corner & 1),
          cell[1] + static_cast<std::uint32_t>((corner >> 1) & 1),
          cell[2] + static_cast<std::uint32_t>(corner >> 2)};
}

/// The nodes at which the solid's sign is sampled, and how accurately the surface is located
/// between them.
template <std::floating_point T>
struct SurfaceGrid {
  const SignedDistanceFunction<T>& solid;
  const GridPatch<T>& nodes;
  double tolerance;  ///< in units of an edge's length

  [[nodiscard]] std::uint32_t count(std::size_t axis) const {
    return static_cast<std::uint32_t>(nodes.indices.length(static_cast<int>(axis)));
  }
  [[nodiscard]] Vec3<T> position(const NodeOffset& node) const {
    return nodes.level.position(nodes.indices.at(node[0], node[1], node[2]));
  }
  /// Whether the inside corners of an ambiguous face belong together: the same for both its cells.
  [[nodiscard]] bool isJoined(const NodeOffset& cell, int face) const;
};

/// The part of an isosurface in a tile (see GridTiles) of up to 8^3 cells: the signs at its nodes,
/// and the points where the surface cuts the edges that begin at them.
///
/// Edges are numbered by their lower nodes, row by row: in each row those along x, then y, then z.
/// A tile has the edges of its first 8 nodes along each axis, or of all where the grid ends.
template <std::floating_point T>
class SurfaceTile {
 public:
  static constexpr std::uint32_t kCells = 8;

  /// The tile of the cells from `first` on. Evaluates the solid; points() are complete after that.
  SurfaceTile(const SurfaceGrid<T>& grid, const NodeOffset& first);

  /// Points on the surface: one on each cut edge, then those in the middle of polygons that need
  /// one.
  [[nodiscard]] std::span<const Vec3<double>> points() const { return points_; }
  void releasePoints() { points_ = {}; }

  [[nodiscard]] const NodeOffset& first() const { return first_; }
  [[nodiscard]] bool isInside(const NodeOffset& node) const {
    return ((rows_[node[2]][node[1]] >> node[0]) & 1U) != 0;
  }
  /// Index in points() of the point on a cut edge that begins at one of this tile's own nodes.
  [[nodiscard]] std::uint32_t edgePoint(const NodeOffset& node, int axis) const;

  /// A cell through which the surface goes.
  struct CutCell {
    NodeOffset cell;  ///< its lowest node in the tile
    unsigned inside;  ///< mask of corners
    unsigned joined;  ///< mask of ambiguous faces
  };
  /// All cut cells, in order.
  [[nodiscard]] std::vector<CutCell> cutCells() const;
  /// Number of points() on edges; those in the middle of polygons follow.
  [[nodiscard]] std::size_t edgePointCount() const { return edgePoints_; }

 private:
  using Row = std::uint16_t;  // a bit for each node along x

  /// Values of the solid at all nodes, x fastest.
  using Values = std::array<T, std::size_t{kCells + 1} * (kCells + 1) * (kCells + 1)>;
  static double valueAt(const Values& values, const NodeOffset& node) {
    return static_cast<double>(values[node[0] + (kCells + 1) * (node[1] + (kCells + 1) * node[2])]);
  }

  void sample(const SurfaceGrid<T>& grid, Values& values);
  void numberEdges();
  /// The cut edges among this tile's own edges along the axis in a row: a bit for each lower node.
  [[nodiscard]] Row cutEdges(std::uint32_t j, std::uint32_t k, int axis) const;
  void findEdgePoints(const SurfaceGrid<T>& grid, const Values& values);
  /// Finds which faces of ambiguous cells are joined, and the points in the middle of polygons that
  /// cannot be triangulated without one; only these cells have such polygons.
  void resolveAmbiguousCells(const SurfaceGrid<T>& grid, const Values& values);
  /// The segment from the middle of the polygon to a corner of the cell with the other sign.
  [[nodiscard]] SignChange<T> throughMiddle(const CellPolygon& polygon, const CutCell& cut,
                                            const SurfaceGrid<T>& grid, const Values& values) const;
  [[nodiscard]] NodeOffset inGrid(const NodeOffset& node) const {
    return {first_[0] + node[0], first_[1] + node[1], first_[2] + node[2]};
  }

  NodeOffset first_;
  NodeOffset nodes_{};  ///< their number along each axis
  NodeOffset own_{};    ///< number of those that begin edges of this tile
  std::array<std::array<Row, kCells + 1>, kCells + 1> rows_{};
  std::array<std::array<std::uint16_t, kCells + 1>, kCells + 1> firstPoint_{};  // of a row
  std::size_t edgePoints_ = 0;
  std::vector<unsigned> joined_;  // for the cut cells with ambiguous faces, in order
  std::vector<Vec3<double>> points_;
};

extern template class SurfaceTile<float>;
extern template class SurfaceTile<double>;
extern template struct SurfaceGrid<float>;
extern template struct SurfaceGrid<double>;

}  // namespace cutwater::detail
