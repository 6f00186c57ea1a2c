#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// What patches have of a cell's wall.
struct CellWall {
  struct OfPatch {
    std::uint32_t patch;
    std::vector<CornerLoop> loops;  ///< polygons, or the faces that they are joined to
  };
  std::uint32_t cell;
  std::vector<OfPatch> parts;
};

/// Joins the polygons of a wall to faces: one a patch if its rim is one loop, and else as few as
/// each have one. There are more where the cell would have fewer than four faces, or no extent
/// along an axis; with `keepsPolygons`, only those without area are joined to others. Loops along a
/// line along an axis are left out: other faces meet along it, see meetEdgeByEdge().
/// @param wall  its polygons.
/// @param others  the number of the cell's other faces.
/// @param axes  a mask of those across which these lie.
/// @param points  of corners.
/// @param keepsPolygons  see above.
void joinWall(CellWall& wall, std::size_t others, unsigned axes,
              std::span<const Vec3<double>> points, bool keepsPolygons);

}  // namespace cutwater
