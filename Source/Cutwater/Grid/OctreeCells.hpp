#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// The domain of an octree mesh: a box of cubic cells, the roots of one octree each. The roots are
/// level 0; cells of each further level are half as wide.
template <std::floating_point T>
class OctreeDomain {
 public:
  /// @throws Error unless the origin is finite, the spacing positive and finite, and there is at
  /// least one root and fewer than 2^21 along each axis.
  OctreeDomain(const Vec3<T>& origin, T spacing, const Index3& roots);

  /// The grid of a level. The bits of a cell's coordinates depend on its global index alone.
  [[nodiscard]] Level<T> level(int level) const;
  [[nodiscard]] IndexBox indices(int level) const;
  /// The finest level that any cell can have.
  [[nodiscard]] int deepest() const;
  [[nodiscard]] Box<T> box() const;

  [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
  [[nodiscard]] T spacing() const { return spacing_; }  ///< of the roots
  [[nodiscard]] const Index3& roots() const { return roots_; }

 private:
  Vec3<T> origin_;
  T spacing_;
  Index3 roots_;
};

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

extern template class OctreeDomain<float>;
extern template class OctreeDomain<double>;
extern template class OctreeCells<float>;
extern template class OctreeCells<double>;

}  // namespace cutwater
