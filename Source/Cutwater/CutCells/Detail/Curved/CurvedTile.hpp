#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Curved/CellLattice.hpp>
#include <Cutwater/CutCells/Detail/Curved/NearFields.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <vector>

namespace cutwater {

/// Whether a box is all fluid or all body for certain, as the value at its center tells.
struct WholeBox {
  bool isWhole = false;
  bool isFluid = false;
};
[[nodiscard]] WholeBox wholeBox(const FluidField& field, const Box<double>& box);

/// Cuts the cells between planes.
[[nodiscard]] TileCut cutTile(const FluidField& field, const GridPlanes& planes,
                              const SolidCutterOptions& how, const CutOptions& options);

/// Which piece of a cell is behind an open part of a finer face.
struct BehindFiner {
  std::uint32_t cell = 0;
  int axis = 0;  ///< across the face
  int side = 0;
  std::uint32_t finer = 0;  ///< number among the finer faces there
  std::uint32_t part = 0;   ///< of those of the finer face
  std::uint32_t piece = 0;
};
/// Some of the cells of a tile, which may have finer ones across their faces.
struct TileLeaves {
  const CellMask& wanted;
  /// The faces of finer cells, as flat boxes, that make up the face of a cell across an axis, below
  /// it or above; none, if there are none.
  FunctionRef<std::vector<Box<double>>(std::uint32_t cell, int axis, int side)> finerFaces;
  const LeavesAround& around;
};
/// Cuts these cells. Sets what is behind parts of finer faces, by cell and side.
[[nodiscard]] TileCut cutTile(const FluidField& field, const GridPlanes& planes,
                              const SolidCutterOptions& how, const CutOptions& options,
                              const TileLeaves& leaves, std::vector<BehindFiner>& behind);

}  // namespace cutwater
