#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

namespace cutwater {

/// Divides cells of which a face is seen from behind from the cell's center, as where an edge of
/// the body pokes far into a leaf: by the plane of such a face, if both parts are seen well. So
/// what codes compute of pyramids over faces has the right sign.
/// @returns the mesh; cells that no such plane mends are as they were.
[[nodiscard]] FluidMesh withDividedCells(FluidMesh mesh);

}  // namespace cutwater
