// Private: what is open of the edges between cells.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

#include <optional>
#include <vector>

namespace cutwater {

/// What is fluid of an edge of the grid.
struct EdgeOpening {
  Index3 cell;  ///< whose lowest corner is the edge's lower end
  int axis = 0;
  double share = 0;     ///< of its length, from 0 to 1
  double centroid = 0;  ///< from its middle, in lengths of the edge
};

/// The twelve edges of each cell that is cut, sorted as below, each once, closed.
[[nodiscard]] std::vector<EdgeOpening> edgesOfCells(const CutCells& cells);

/// Open parts of edges, by cell as rows are, and by axis.
class EdgeOpenings {
 public:
  EdgeOpenings() = default;
  /// Those of cells that were cut with polygons: the sides of outlines of arcs in the borders of
  /// their faces. An edge that is not among them is none of a cell that is cut.
  explicit EdgeOpenings(const CutCells& cells);
  /// These edges, in any order; those that are there twice are the same.
  explicit EdgeOpenings(std::vector<EdgeOpening> edges);

  [[nodiscard]] std::optional<EdgeOpening> at(const Index3& cell, int axis) const;

 private:
  std::vector<EdgeOpening> edges_;
};

}  // namespace cutwater
