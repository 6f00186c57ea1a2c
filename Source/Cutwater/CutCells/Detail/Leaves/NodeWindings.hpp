#pragma once

#include <Cutwater/CutCells/Detail/Tiles/CutTiles.hpp>

#include <vector>

namespace cutwater {

/// The winding numbers of a box's nodes, in the order of TileNumbers, from that of the node of
/// lowest indices: what the triangles add that the ways from there to the others pass through. Few
/// triangles are on any of these ways, so this costs far less than to cut cells by all of them.
///
/// @param triangles  all that meet the box.
[[nodiscard]] std::vector<std::int32_t> nodeWindings(const CutSurface& surface,
                                                     const GridPlanes& planes,
                                                     std::span<const std::uint32_t> triangles,
                                                     int winding);

/// Those of the triangles whose boxes meet cells that are wanted, in their order.
[[nodiscard]] std::vector<std::uint32_t> trianglesAtCells(const CutSurface& surface,
                                                          const GridPlanes& planes,
                                                          std::span<const std::uint32_t> triangles,
                                                          const CellMask& wanted);

}  // namespace cutwater
