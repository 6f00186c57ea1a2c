#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Rows/PeriodicRows.hpp>

namespace cutwater {

/// The fine cells that make up coarse cells, as nodes that open faces connect. A node is a piece of
/// a fine cell, or a whole fine cell of fluid in a coarse cell that is cut. Pieces come first, and
/// have their numbers.
class CoarseNodes {
 public:
  /// Integer coordinates of a fine or a coarse cell.
  using Place = std::array<std::int64_t, 3>;

  /// An open face between two fine cells.
  struct Face {
    Index3 cell;          ///< the coarse cell above it
    bool isBetween;       ///< whether it lies between two coarse cells
    int axis;             ///< across it
    std::uint32_t below;  ///< a node, kWholeCell or kBeyond: see CutCells
    std::uint32_t above;
    double area;
    Vec3<double> centroid;
    Index3 fine;        ///< the fine cell above it
    std::uint32_t arc;  ///< its row; kNoRow for a whole face to a whole cell
  };

  /// @throws Error(Argument) as coarsened() says.
  /// Along axes that the box spans, the ends of the period must be joined, see withJoinedEnds().
  CoarseNodes(const CutCells& fine, const std::array<int, 3>& ratios, const SpannedAxes& spanned);

  /// The planes of the coarse cells, and those that are cut, in order.
  [[nodiscard]] const CellPlanes& grid() const { return coarse_.grid; }
  [[nodiscard]] const std::vector<Index3>& cells() const { return coarse_.cells.index; }

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(nodes_.size()); }
  /// The row of a node's coarse cell, and its fine cell.
  [[nodiscard]] std::uint32_t rowOf(std::uint32_t node) const { return nodes_[node].row; }
  [[nodiscard]] Index3 cellOf(std::uint32_t node) const {
    return fineCell(nodes_[node].row, nodes_[node].number);
  }
  /// Which faces of a node's fine cell lie in those of its coarse cell: bits as
  /// CutCells::Cells::wallFaces.
  [[nodiscard]] unsigned outerFaces(std::uint32_t node) const;
  /// The lowest fine cell of a coarse one.
  [[nodiscard]] Index3 firstOf(const Index3& coarse) const;

  /// Calls visit for every open face that bounds a node.
  void forFaces(FunctionRef<void(const Face&)> visit) const;

 private:
  struct Node {
    std::uint32_t row = 0;
    std::size_t number = 0;  ///< of the fine cell within the coarse one
  };

  void makeGrid();
  void findRows();
  void addNodes();
  [[nodiscard]] Place coarse(const Place& fine) const;
  [[nodiscard]] std::size_t numberWithin(const Place& fine) const;
  [[nodiscard]] Index3 fineCell(std::uint32_t row, std::size_t number) const;
  [[nodiscard]] std::uint32_t wholeNode(const Index3& cell) const;
  void forFacesOfWhole(std::uint32_t node, FunctionRef<void(const Face&)> visit) const;
  [[nodiscard]] Face faceBelow(const Index3& cell, int axis) const;

  const CutCells& fine_;
  IndexBox box_;
  SpannedAxes spanned_;
  Place ratios_{};
  std::size_t perCell_ = 0;  // fine cells in a coarse one
  CutCells coarse_;          // its grid and cells alone
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> whole_;  // nodes of whole cells, for each fine cell of each row
};

}  // namespace cutwater
