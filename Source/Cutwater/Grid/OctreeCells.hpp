#pragma once

#include <Cutwater/Grid/OctreeDomain.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A cell of an octree mesh, given by its level and its global index there.
struct OctreeCell {
  Index3 index;
  std::uint8_t level = 0;
  BoxClass kind = BoxClass::Unknown;

  bool operator==(const OctreeCell&) const = default;
};

/// The cells of an octree mesh in order: all of them, or a contiguous part, such as that of one MPI
/// rank.
template <std::floating_point T>
class OctreeCells {
 public:
  /// `deepest`: the finest level that cells may have, in the whole mesh.
  /// @throws Error unless the cells are within the domain, no finer than that, in the order of
  /// their Morton codes, and do not overlap.
  OctreeCells(const OctreeDomain<T>& domain, int deepest, std::vector<OctreeCell> cells);

  [[nodiscard]] const OctreeDomain<T>& domain() const { return domain_; }
  /// The cells, in the order of their Morton codes: neighbours in space are mostly neighbours in
  /// the list.
  [[nodiscard]] std::span<const OctreeCell> cells() const { return cells_; }
  /// The finest level that cells may have.
  [[nodiscard]] int deepest() const { return static_cast<int>(levels_.size()) - 1; }
  /// Number of cells of the given kind.
  [[nodiscard]] std::size_t count(BoxClass kind) const;

  /// Centre and box of a cell, with the bits that its level gives: see Level::position() and
  /// Level::cell().
  [[nodiscard]] Vec3<T> center(const OctreeCell& cell) const {
    return levels_[cell.level].position(cell.index);
  }
  [[nodiscard]] Box<T> box(const OctreeCell& cell) const {
    return levels_[cell.level].cell(cell.index);
  }

 private:
  OctreeDomain<T> domain_;
  std::vector<Level<T>> levels_;
  std::vector<OctreeCell> cells_;
};

extern template class OctreeCells<float>;
extern template class OctreeCells<double>;

}  // namespace cutwater
