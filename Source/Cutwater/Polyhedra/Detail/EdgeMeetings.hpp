#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

namespace cutwater {

/// Makes the faces of each cell meet edge by edge: an edge along an axis goes through the points
/// on it that other faces have, as where finer leaves are across an edge of a leaf. A face that
/// then touches itself becomes several, and one there and back none.
void meetEdgeByEdge(FluidMesh& mesh, int threads = 0);

}  // namespace cutwater
