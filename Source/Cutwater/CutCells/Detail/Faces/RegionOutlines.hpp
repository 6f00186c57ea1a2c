#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>

namespace cutwater {

/// Appends the outlines of the open parts of a face on which triangles meet, in their order, as
/// addOutlines() does for others: what bounds their convex regions, where no other region of the
/// part is beside it. Corners are ends of traces and of stretches, to the bit, or where traces
/// cross, rounded once for both cells. An outline is empty if nothing is left of it.
void addRegionOutlines(const FacePieces& faces, std::uint32_t face, CutCells::Polygons& out);

}  // namespace cutwater
