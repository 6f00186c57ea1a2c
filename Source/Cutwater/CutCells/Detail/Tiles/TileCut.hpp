#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/CutBlocks.hpp>

#include <utility>

namespace cutwater {

/// The polygons of one tile, in its coordinates.
struct TilePolygons {
  CutCells::Polygons arcs;   ///< by arc; empty for those of open patches
  CutCells::Polygons walls;  ///< in the order of pieces and patches
  /// Of each of them, the piece and the patch, see WallPolygons.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wallOf;
  std::vector<std::uint32_t> fragmentOf;  ///< and the fragment, or kNone where triangles meet
};

/// The cut cells of one tile, with its own numbers of cells, pieces and faces.
struct TileCut {
  TileNumbers numbers{{}};
  CellPieces content;
  std::vector<std::uint32_t> cells;        ///< those that are cut, ascending
  std::vector<std::uint32_t> firstPiece;   ///< of each of them, then the number of all
  std::vector<std::uint8_t> fluidCorners;  ///< as in CutCells
  std::vector<char> isTouched;             ///< whether the surface merely touches them
  std::vector<std::uint8_t> meets;         ///< as in CutCells
  std::vector<double> error;               ///< the same
  CellMask isBody;                         ///< cells without fluid
  TilePolygons polygons;                   ///< on request
  CutCells::Moments moments;               ///< the same
  CutCells::Quadrature quadrature;         ///< the same
};

/// What a tile's cut cells are made of. Views the input's mask and planes.
struct TileParts {
  TileParts(const CutSurface& whole, const TileInput& input);
  TileParts(const TileParts&) = delete;
  TileParts& operator=(const TileParts&) = delete;
  ~TileParts() = default;

  const CellMask* wanted;
  CutFrame frame;
  GridPlanes planes;
  TileSurface surface;
  EdgeStretches stretches;
  FacePieces faces;
};

/// Joins the parts to cut cells.
[[nodiscard]] TileCut cutTile(const TileParts& parts, const CutOptions& options);
[[nodiscard]] inline TileCut cutTile(const CutSurface& surface, const TileInput& input,
                                     const CutOptions& options) {
  return cutTile(TileParts(surface, input), options);
}

}  // namespace cutwater
