#pragma once

#include <Cutwater/Polyhedra/Detail/DividingPlanes.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>

#include <cstdint>
#include <optional>

namespace cutwater {

/// Divides a cell by a plane. Its volume is shared out as those of the two polyhedra. What a face
/// has in the plane goes to the part that it bounds.
/// @returns the part that the normal looks into, which is a new cell; none, and the mesh is as it
/// was, if there are not two parts that one face between them closes and that have enough faces.
std::optional<std::uint32_t> divideCell(EditedMesh& mesh, std::uint32_t cell,
                                        const DividingPlane& plane);

}  // namespace cutwater
