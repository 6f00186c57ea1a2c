#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/CutTiles.hpp>

#include <bitset>
#include <utility>

namespace cutwater {

/// The polygons of one tile, in its coordinates.
struct TilePolygons {
  CutCells::Polygons arcs;   ///< by arc
  CutCells::Polygons walls;  ///< in the order of pieces and patches
  /// Of each of them, the piece and the patch.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wallOf;
};

/// The cut cells of one tile, with its own numbers of cells, pieces and faces.
struct TileCut {
  static constexpr std::size_t kCells =
      std::size_t{CutTiles::kWidth} * CutTiles::kWidth * CutTiles::kWidth;

  TileNumbers numbers{{}};
  CellPieces content;
  std::vector<std::uint32_t> cells;        ///< those that are cut, ascending
  std::vector<std::uint32_t> firstPiece;   ///< of each of them, then the number of all
  std::vector<std::uint8_t> fluidCorners;  ///< as in CutCells
  std::vector<char> isTouched;             ///< whether the surface merely touches them
  std::bitset<kCells> isBody;              ///< cells without fluid
  TilePolygons polygons;                   ///< on request
  CutCells::Moments moments;               ///< the same
};

/// Cuts the cells of a tile.
[[nodiscard]] TileCut cutTile(const CutSurface& surface, const CutTiles& tiles, std::size_t tile,
                              const CutOptions& options);

}  // namespace cutwater
