// Private: what is fluid of cells, faces, edges and nodes, within and beyond a box of cut cells.
#pragma once

#include <Cutwater/Adapters/Detail/EdgeOpenings.hpp>
#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace cutwater {

/// What SingleValuedCells knows of a level.
///
/// A cell, a face, an edge or a node is named by its lowest corner, and by the axes along which it
/// extends: bit n for axis n. Beyond the box it is what it would be if all of it were moved along
/// the axes without a period into the nearest face of the box: a cell becomes a face, an edge or a
/// node. Cells in a plane extend along z for ever: a face is a side of them there, and what extends
/// along z alone is a corner.
class SingleValuedParts {
 public:
  static constexpr unsigned kCell = 7;

  struct Part {
    double share = 0;            ///< from 0 to 1
    Vec3<double> centroid = {};  ///< from the middle, in widths of cells
  };
  struct Wall {
    /// The open shares of the faces across each axis, the low one first.
    std::array<std::array<double, 2>, 3> open{};
    Vec3<double> vector;    ///< what closes them, in shares of faces: out of the fluid
    Vec3<double> centroid;  ///< from the middle of the cell, in its widths
  };

  /// @param raw  what is open of the edges of these cells before any face was closed.
  SingleValuedParts(MergedCells merged, const EdgeOpenings& raw,
                    const SingleValuedOptions& options);

  [[nodiscard]] const MergedCells& merged() const { return merged_; }
  [[nodiscard]] const IndexBox& box() const { return box_; }
  /// Along any axis.
  [[nodiscard]] bool isPeriodic() const {
    return isPeriodic_[0] || isPeriodic_[1] || isPeriodic_[2];
  }
  [[nodiscard]] const SingleValuedOptions& options() const { return options_; }
  /// The number of axes across which there are faces.
  [[nodiscard]] int dimensions() const { return options_.isPlane ? 2 : 3; }

  [[nodiscard]] Part partOf(const Index3& at, unsigned extent) const;
  [[nodiscard]] Part partOfFace(const Index3& cell, int axis) const {
    return partOf(cell, kCell & ~(1U << static_cast<unsigned>(axis)));
  }
  [[nodiscard]] Part partOfEdge(const Index3& cell, int axis) const {
    return partOf(cell, 1U << static_cast<unsigned>(axis));
  }
  /// A cell beyond the box that has no wall vector although it is not all fluid counts as body.
  [[nodiscard]] FluidClass kindOf(const Index3& cell) const;
  /// Of a cell that is cut.
  [[nodiscard]] Wall wallOf(const Index3& cell) const;
  /// -1 in the fluid, 0 on closed faces, 1 in the body.
  [[nodiscard]] double levelSetAt(const Index3& node) const;

  /// What is open of the edges of cells that each join two along each axis.
  [[nodiscard]] EdgeOpenings coarseEdges(const CutCells& coarse) const;

 private:
  struct Place {
    Index3 at;
    unsigned extent = 0;
  };

  [[nodiscard]] Place inBox(Place place) const;
  [[nodiscard]] Part ofCell(const Index3& cell) const;
  [[nodiscard]] Part ofFace(const Place& face) const;
  [[nodiscard]] Part ofEdge(const Place& edge) const;
  [[nodiscard]] double levelSetIn(const Place& node) const;
  [[nodiscard]] bool touchesClosedFace(const Place& place) const;
  [[nodiscard]] EdgeOpening finalEdge(const Place& edge, const EdgeOpenings& raw) const;
  template <typename Visit>
  void forCellsAround(const Place& place, const Visit& visit) const;

  MergedCells merged_;
  SingleValuedOptions options_;
  IndexBox box_;
  std::array<bool, 3> isPeriodic_{};
  EdgeOpenings edges_;
};

}  // namespace cutwater
