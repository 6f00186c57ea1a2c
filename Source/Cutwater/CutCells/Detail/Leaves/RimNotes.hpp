#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>

namespace cutwater {

/// Notes in LeafTile::rims what a tile knows about faces to leaves of other levels.
void noteRims(const LeafGrid& grid, const TileParts& parts, bool meetsItself, bool withPolygons,
              LeafTile& tile);

}  // namespace cutwater
