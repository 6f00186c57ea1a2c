#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileSurface.hpp>

namespace cutwater {

/// A part of a grid's edge in the fluid, between two crossings or ends of the edge.
struct EdgeStretch {
  /// More than rounding moves the points of a surface whose coordinates are up to about 1.
  static constexpr double kRounding = 0x1p-46;

  double from = 0;
  double to = 0;
  std::uint32_t start = kNone;  ///< the triangle crossed there; kNone: the end of the edge
  std::uint32_t end = kNone;

  [[nodiscard]] double length() const { return to - from; }
  [[nodiscard]] double middle() const { return 0.5 * (from + to); }
};

/// Where the nodes and edges of a box of cells are in the fluid: where the winding number of the
/// surface is 0 or less. It is carried from node to node by the crossings in between, which are
/// those of the moved surface: all ways from one node to another give the same number.
class EdgeStretches {
 public:
  /// `winding` is that of the node of lowest indices; `windings` are those of all nodes: needed
  /// only if the surface lacks triangles that meet the box. Then stretches are right where it has
  /// all that meet an edge.
  EdgeStretches(const TileSurface& surface, const GridPlanes& planes, int winding,
                std::span<const std::int32_t> windings = {});

  [[nodiscard]] bool isFluid(const TilePlace& node) const {
    return windings_[numbers_.node(node)] <= 0;
  }
  [[nodiscard]] int winding(const TilePlace& node) const { return windings_[numbers_.node(node)]; }
  /// The stretches of an edge, in ascending order: one, from node to node, where nothing crosses
  /// it.
  [[nodiscard]] std::span<const EdgeStretch> of(int axis, const TilePlace& first) const;

 private:
  void setWindings(const TileSurface& surface, int winding);
  void setStretches(const TileSurface& surface, const GridPlanes& planes);
  /// Adds the stretches of an edge that begins at this winding number; `takeTurns`: at crossings,
  /// fluid and body do.
  void divide(const Interval<double>& edge, int winding, bool takeTurns,
              std::vector<EdgeCrossing>& crossings);

  TileNumbers numbers_;
  std::vector<std::int32_t> windings_;                  // of nodes
  std::array<std::vector<EdgeStretch>, 3> wholeEdges_;  // along each axis: those not crossed
  std::vector<std::uint32_t> crossedEdge_;              // by edge: its number below, or kNone
  std::vector<std::uint32_t> firstOfCrossed_;           // one more than crossed edges
  std::vector<EdgeStretch> stretches_;
};

}  // namespace cutwater
