#pragma once

#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/NearFields.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileNumbers.hpp>

namespace cutwater {

/// Whether values at the corners of a box, or a rectangle, leave room for a wall in it.
[[nodiscard]] bool leavesRoom(const FluidField& field, const Box<double>& box,
                              std::span<const double> corners);

/// What is known of a field at the nodes and edges of a tile's grid; edges, and gradients at nodes,
/// once they are asked for. What lies in planes beyond the seam is found a period below.
class GridSamples {
 public:
  /// Views both.
  GridSamples(NearFields& fields, const GridPlanes& planes);

  [[nodiscard]] double valueAt(const TilePlace& node) const { return values_[numbers_.node(node)]; }
  /// The box of a cell, or the rectangle of the face below it across an axis.
  [[nodiscard]] Box<double> boxOf(const TilePlace& cell, int flatAxis = -1) const;
  /// See above.
  [[nodiscard]] bool leavesRoom(const TilePlace& cell, int flatAxis = -1) const;
  /// Corners and edges of such a box.
  [[nodiscard]] BoxSamples of(const TilePlace& cell, int flatAxis = -1);

 private:
  [[nodiscard]] Vec3<double> pointAt(const TilePlace& node) const {
    return {planes_.at(0, node[0]), planes_.at(1, node[1]), planes_.at(2, node[2])};
  }
  [[nodiscard]] Vec3<double> shiftAt(const TilePlace& node) const {
    return {planes_.shiftAt(0, node[0]), planes_.shiftAt(1, node[1]), planes_.shiftAt(2, node[2])};
  }
  void findEdges(std::span<CrossedEdge* const> edges, std::span<const Vec3<double>> shifts);
  const Vec3<double>& gradientAt(const TilePlace& node);

  NearFields& fields_;
  const FluidField& field_;
  const GridPlanes& planes_;
  TileNumbers numbers_;
  std::vector<double> values_;
  std::vector<Vec3<double>> gradients_;
  std::vector<char> hasGradient_;
  std::vector<CrossedEdge> edges_;
  std::vector<char> hasEdge_;
};

}  // namespace cutwater
