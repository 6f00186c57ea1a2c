// What is asked of cut cells and of cut leaves alike.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

/// The cells that are cut, without those beyond the box, and their pieces.
inline std::size_t cutCount(const CutCells& cells) {
  return cells.cellCount;
}
inline std::size_t cutCount(const CutLeaves& leaves) {
  return leaves.cut.leaf.size();
}
inline std::size_t pieceCount(const CutCells& cells) {
  return cells.pieceCount;
}
inline std::size_t pieceCount(const CutLeaves& leaves) {
  return leaves.pieces.cell.size();
}
inline const CutCells::Cells& rowsOf(const CutCells& cells) {
  return cells.cells;
}
inline const CutLeaves::Leaves& rowsOf(const CutLeaves& leaves) {
  return leaves.cut;
}

/// Of a row of those.
inline Box<double> boxOfRow(const CutCells& cells, std::size_t row) {
  return cells.boxOf(cells.cells.index[row]);
}
inline const Box<double>& boxOfRow(const CutLeaves& leaves, std::size_t row) {
  return leaves.cut.box[row];
}
/// The area of its largest face.
template <typename Cut>
double largestFace(const Cut& cut, std::size_t row) {
  const auto size = boxOfRow(cut, row).size();
  return std::max({size.y * size.z, size.z * size.x, size.x * size.y});
}

/// See CutCells::isTouchedOnly(). Walls in faces add up to the components of their vector, where no
/// two of the faces are opposite ones.
template <typename Cut>
bool isOnlyTouched(const Cut& cut, std::size_t row) {
  constexpr double kRounding = 1e-12;
  const auto& rows = rowsOf(cut);
  const auto piece = rows.firstPiece[row];
  const unsigned faces = rows.wallFaces[row];
  if (faces == 0 || rows.meets[row] != 0 || rows.firstPiece[row + 1] != piece + 1) return false;
  const auto size = boxOfRow(cut, row).size();
  const double whole = size.x * size.y * size.z;
  if (cut.pieces.volume[piece] < (1 - kRounding) * whole) return false;
  const double rounding = kRounding * largestFace(cut, row);
  double most = rounding;  // that walls in the faces may have
  double least = -rounding;
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned ofAxis = faces >> static_cast<unsigned>(2 * axis) & 3U;
    const double part = std::abs(cut.pieces.wallVector[piece][axis]);
    if (ofAxis == 0 && part > rounding) return false;
    least += part;
    most += ofAxis == 3 ? 2 * whole / size[axis] : part;
  }
  return least <= cut.pieces.wallArea[piece] && cut.pieces.wallArea[piece] <= most;
}

/// Of the face that an arc lies in.
inline double faceAreaOf(const CutCells& cells, std::size_t arc) {
  return cells.faceArea(cells.arcs.cell[arc], cells.arcs.axis[arc]);
}
inline double faceAreaOf(const CutLeaves& leaves, std::size_t arc) {
  return leaves.arcs.faceArea[arc];
}

/// Whether a piece, or what stands in its place, can lie beside an arc. What is beyond an open
/// patch is beyond all cells.
inline bool canBeBeside(const CutCells& cells, std::size_t arc, bool isBelow, std::uint32_t piece) {
  const auto cell = isBelow ? cells.arcs.cellBelow(arc) : cells.arcs.cell[arc];
  if (piece < cells.pieces.cell.size()) {
    return cells.cells.index[cells.pieces.cell[piece]] == cell;
  }
  const bool isInBox = cells.grid.indices().contains(cell);
  if (piece == CutCells::kBeyond) {
    return !isInBox || cells.openArcs.patchOf(static_cast<std::uint32_t>(arc)) != CutCells::kNoRow;
  }
  return piece == CutCells::kWholeCell && (!isInBox || cells.classOf(cell) == FluidClass::Fluid);
}
inline bool canBeBeside(const CutLeaves& leaves, std::size_t arc, bool isBelow,
                        std::uint32_t piece) {
  const auto leaf = isBelow ? leaves.arcs.leafBelow[arc] : leaves.arcs.leafAbove[arc];
  if (piece < leaves.pieces.cell.size()) return leaves.cut.leaf[leaves.pieces.cell[piece]] == leaf;
  if (piece == CutLeaves::kBeyond) return leaf == CutLeaves::kNoLeaf;
  return piece == CutLeaves::kWholeCell && leaf != CutLeaves::kNoLeaf &&
         leaves.classes[leaf] == FluidClass::Fluid;
}

}  // namespace cutwater
