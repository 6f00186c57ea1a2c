#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

namespace cutwater {

/// Makes the faces of each cell meet edge by edge: an edge along an axis goes through the points
/// on it that other faces have, as where finer leaves are across an edge of a leaf.
void meetEdgeByEdge(FluidMesh& mesh);

}  // namespace cutwater
