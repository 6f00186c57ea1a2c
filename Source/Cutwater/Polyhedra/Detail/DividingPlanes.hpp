#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>

#include <cstdint>
#include <vector>

namespace cutwater {

/// A plane through a cell.
struct DividingPlane {
  Vec3<double> point;
  Vec3<double> normal;                      ///< of any length
  std::vector<std::uint32_t> corners = {};  ///< those of the cell that count as in it
  double near = 1e-3;  ///< how close to it others do, as a share of the cell's width
};

/// Planes that divide a cell, two dozen at most: those of its largest walls and its other faces,
/// through the edge between two walls along an axis or between both, and those that two edges of a
/// wall span at a corner.
[[nodiscard]] std::vector<DividingPlane> dividingPlanes(EditedMesh& mesh, std::uint32_t cell);

}  // namespace cutwater
