#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

namespace cutwater {

/// Rules for the pieces of a tile, their walls and arcs, exact for polynomials up to a degree, in
/// the coordinates of the world but for the frame's shift. `cut` has its polygons, and `moments`
/// are its own of this degree.
///
/// Of the volume of a piece and of an arc, and of each polygon of a wall, there are no more points
/// than monomials. The weights of a row add up to what the row of volumes or areas says.
[[nodiscard]] CutCells::Quadrature findQuadrature(const TileCut& cut,
                                                  const CutCells::Moments& moments,
                                                  const CutFrame& frame);

}  // namespace cutwater
