#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>

namespace cutwater {

/// The moments of a tile's pieces and arcs, in their orders, in the units of the world and about
/// centroids as they are stated there.
///
/// They are sums over the same fragments, open parts, traces and stretches as volumes and areas, in
/// an order that depends on the cell or the face alone.
[[nodiscard]] CutCells::Moments findMoments(const FacePieces& faces, const CellPieces& content,
                                            const CutFrame& frame, int degree);

}  // namespace cutwater
