#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <AMReX_EB2.H>
#include <gtest/gtest.h>

namespace cutwater::test {

/// What holds for every level of AMReX's EB2, of all cells that its boxes hold, and what was seen.
class EBRules {
 public:
  explicit EBRules(const amrex::EB2::Level& level)
      : fields_(const_cast<amrex::EB2::Level&>(level).fields()) {  // NOLINT
    for (amrex::MFIter grid(fields_.volfrac); grid.isValid(); ++grid) {
      const auto lo = amrex::lbound(grid.validbox());
      const auto hi = amrex::ubound(grid.validbox());
      for (int k = lo.z; k <= hi.z; ++k) {
        for (int j = lo.y; j <= hi.y; ++j) {
          for (int i = lo.x; i <= hi.x; ++i) check(grid, {i, j, k});
        }
      }
    }
  }

  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] std::size_t cut() const { return cut_; }
  /// Cells for which a rule does not hold: 0.
  [[nodiscard]] std::size_t broken() const { return broken_; }
  [[nodiscard]] double worstClosure() const { return worstClosure_; }

 private:
  static constexpr int kDim = AMREX_SPACEDIM;
  using Cell = std::array<int, 3>;

  static Cell beside(Cell cell, int axis, int steps) {
    cell[static_cast<std::size_t>(axis)] += steps;
    return cell;
  }
  [[nodiscard]] double aperture(const amrex::MFIter& grid, const Cell& face, int axis) const {
    const auto array = fields_.areafrac[static_cast<std::size_t>(axis)].const_array(grid);
    return array(face[0], face[1], face[2]);
  }

  void check(const amrex::MFIter& grid, const Cell& cell) {
    const auto [i, j, k] = cell;
    const auto flag = fields_.cellflag.const_array(grid)(i, j, k);
    const double volume = fields_.volfrac.const_array(grid)(i, j, k);
    ++cells_;
    bool isRight = haveRightBits(grid, cell, flag);
    for (int axis = 0; axis < kDim; ++axis) {
      for (const int side : {0, 1}) {
        const double open = aperture(grid, beside(cell, axis, side), axis);
        isRight = isRight && 0 <= open && open <= 1 &&
                  hasFaceInRange(grid, beside(cell, axis, side), axis);
        if (flag.isRegular()) isRight = isRight && open == 1;
        if (flag.isCovered()) isRight = isRight && open == 0;
      }
    }
    if (flag.isRegular()) {
      isRight = isRight && volume == 1;
    } else if (flag.isCovered()) {
      isRight = isRight && volume == 0 && isClosedAtNodes(grid, cell);
    } else {
      ++cut_;
      isRight =
          isRight && flag.isSingleValued() && 0 < volume && volume <= 1 && hasWall(grid, cell);
    }
    if (!isRight) ++broken_;
  }

  [[nodiscard]] bool hasFaceInRange(const amrex::MFIter& grid, const Cell& face, int axis) const {
    const auto array = fields_.facecent[static_cast<std::size_t>(axis)].const_array(grid);
    for (int n = 0; n < kDim - 1; ++n) {
      if (!(std::abs(array(face[0], face[1], face[2], n)) <= 0.5)) return false;
    }
    return true;
  }
  /// Connected across a face if and only if some of it is open.
  [[nodiscard]] bool haveRightBits(const amrex::MFIter& grid, const Cell& cell,
                                   const amrex::EBCellFlag& flag) const {
    if (flag.isCovered()) return true;
    for (int axis = 0; axis < kDim; ++axis) {
      for (const int side : {0, 1}) {
        const auto to = beside({0, 0, 0}, axis, 2 * side - 1);
        const bool isOpen = aperture(grid, beside(cell, axis, side), axis) > 0;
        if (flag.isConnected(to[0], to[1], to[2]) != isOpen) return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool isClosedAtNodes(const amrex::MFIter& grid, const Cell& cell) const {
    const auto levelSet = fields_.levelset.const_array(grid);
    for (int corner = 0; corner < (1 << kDim); ++corner) {
      if (levelSet(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2)) <
          0) {
        return false;
      }
    }
    return true;
  }
  /// A wall that closes the open parts, and centroids in the cell.
  [[nodiscard]] bool hasWall(const amrex::MFIter& grid, const Cell& cell) {
    const auto [i, j, k] = cell;
    const double area = fields_.bndryarea.const_array(grid)(i, j, k);
    bool isRight = area > 0;
    double square = 0;
    for (int axis = 0; axis < kDim; ++axis) {
      const double normal = fields_.bndrynorm.const_array(grid)(i, j, k, axis);
      const double open = aperture(grid, cell, axis) - aperture(grid, beside(cell, axis, 1), axis);
      square += normal * normal;
      worstClosure_ = std::max(worstClosure_, std::abs(area * normal - open));
      isRight = isRight && std::abs(fields_.bndrycent.const_array(grid)(i, j, k, axis)) <= 0.5 &&
                std::abs(fields_.centroid.const_array(grid)(i, j, k, axis)) <= 0.5;
    }
    constexpr double kRounding = std::is_same_v<amrex::Real, float> ? 1e-5 : 1e-13;
    return isRight && std::abs(square - 1) < kRounding;
  }

  amrex::EB2::Level::Fields fields_;
  std::size_t cells_ = 0;
  std::size_t cut_ = 0;
  std::size_t broken_ = 0;
  double worstClosure_ = 0;
};

}  // namespace cutwater::test
