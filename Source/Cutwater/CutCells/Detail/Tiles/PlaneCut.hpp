#pragma once

#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

namespace cutwater {

/// The z coordinates, in the frame of a surface, of the planes between which a plane section is
/// cut: the plane itself is the second of three.
[[nodiscard]] std::array<double, 3> planesAround(double z);

/// Cuts the rectangles of a tile that is two layers of cells, in the plane between them: the faces
/// between the layers. The cells of the upper layer stand for them, as if they were of this
/// thickness, with walls and open parts across x and y.
[[nodiscard]] TileCut cutTileInPlane(const CutSurface& surface, const CutBlocks& tiles,
                                     std::size_t tile, double thickness);

}  // namespace cutwater
