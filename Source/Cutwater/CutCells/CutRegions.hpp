#pragma once

#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// A connected region of fluid.
struct CutRegion {
  double volume = 0;
  std::size_t pieces = 0;      ///< of cut cells
  std::size_t wholeCells = 0;  ///< that are all fluid
  /// Whether it is open to what lies beyond the box, where a mesh has no leaf, or beyond an open
  /// patch. If not, it is a cavity; or, in a box that spans a whole period, all there is in it.
  bool goesOn = false;
};

/// The connected regions of the fluid in cut cells: pieces, and cells that are all fluid, joined by
/// open parts of faces alone. So no plate leaks, and no gap is closed, however thin.
class CutRegions {
 public:
  /// In place of a region: there is none.
  static constexpr std::uint32_t kNone = CutCells::kNoRow;

  explicit CutRegions(const CutCells& cells);
  /// Of the leaves of this mesh.
  template <std::floating_point T>
  CutRegions(const CutLeaves& leaves, const OctreeCells<T>& mesh);

  /// The regions, largest first.
  [[nodiscard]] std::span<const CutRegion> regions() const { return regions_; }
  /// The region of a piece; kNone for pieces in cells beyond the box.
  [[nodiscard]] std::uint32_t ofPiece(std::uint32_t piece) const { return ofPiece_[piece]; }
  /// The region of a cell of the box that is all fluid; kNone for others.
  [[nodiscard]] std::uint32_t ofCell(const Index3& cell) const;
  /// The same for a leaf.
  [[nodiscard]] std::uint32_t ofLeaf(std::uint32_t leaf) const { return ofLeaf_[leaf]; }

 private:
  /// Cells [first, last), counted through the box, of one line along x.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    std::uint32_t region = kNone;
  };
  class Builder;

  IndexBox box_{};
  std::vector<CutRegion> regions_;
  std::vector<std::uint32_t> ofPiece_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> ofLeaf_;
};

}  // namespace cutwater
