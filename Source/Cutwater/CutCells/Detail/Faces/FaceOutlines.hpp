#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>

namespace cutwater {

/// Appends the outlines of the open parts of a cut face, in their order: of each one polygon, whose
/// holes are cut open by an edge there and back.
///
/// What follows what around a part is known from the moved surface, so that outlines close whatever
/// the rounding. Their points are ends of traces and of stretches, to the bit; equal ones in a row
/// are one.
void addOutlines(const TileSurface& surface, const EdgeStretches& stretches,
                 const FacePieces& faces, const GridPlanes& planes, std::uint32_t face,
                 CutCells::Polygons& out);

/// Appends the outline of a whole face.
void addWholeOutline(const TileNumbers& numbers, const GridPlanes& planes, std::uint32_t face,
                     CutCells::Polygons& out);

}  // namespace cutwater
