#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

#include <span>

namespace cutwater::detail {

/// What pictures need of the rows of cut cells, or of cut leaves. Refers to them.
class CellRows {
 public:
  explicit CellRows(const CutCells& cells) : cells_(&cells) {}
  explicit CellRows(const CutLeaves& leaves) : leaves_(&leaves) {}

  [[nodiscard]] bool areLeaves() const { return leaves_ != nullptr; }
  [[nodiscard]] std::size_t pieceCount() const {
    return cells_ != nullptr ? cells_->pieceCount : leaves_->pieces.cell.size();
  }
  /// The first piece of a row; of the row after it, one more than the last.
  [[nodiscard]] std::uint32_t firstPiece(std::size_t row) const {
    return cells_ != nullptr ? cells_->cells.firstPiece[row] : leaves_->cut.firstPiece[row];
  }
  [[nodiscard]] Box<double> boxOf(std::size_t row) const {
    return cells_ != nullptr ? cells_->boxOf(cells_->cells.index[row]) : leaves_->cut.box[row];
  }
  [[nodiscard]] bool isThin(std::size_t row) const {
    return cells_ != nullptr ? cells_->cells.isThin(row) : leaves_->cut.isThin(row);
  }
  [[nodiscard]] double volumeFraction(std::uint32_t piece) const {
    return cells_ != nullptr ? cells_->volumeFraction(piece) : leaves_->volumeFraction(piece);
  }
  /// The piece of each part of a wall.
  [[nodiscard]] std::span<const std::uint32_t> wallParts() const {
    return cells_ != nullptr ? cells_->wallParts.piece : leaves_->wallParts.piece;
  }
  /// The polygons of walls, and which is the first of each part.
  [[nodiscard]] const CutCells::Polygons& wallPolygons() const {
    return cells_ != nullptr ? cells_->wallPolygons : leaves_->wallPolygons;
  }
  [[nodiscard]] std::span<const std::uint64_t> firstWallPolygon() const {
    return cells_ != nullptr ? cells_->firstWallPolygon : leaves_->firstWallPolygon;
  }

 private:
  const CutCells* cells_ = nullptr;
  const CutLeaves* leaves_ = nullptr;
};

}  // namespace cutwater::detail
