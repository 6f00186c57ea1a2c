#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Grid/Octree.hpp>

namespace cutwater {

namespace detail {
class DisjointSets;
}  // namespace detail

/// A connected part of the fluid: Outside cells that are joined across their faces.
template <std::floating_point T>
struct FluidRegion {
  std::size_t cells = 0;  ///< number of Outside cells
  double volume = 0;      ///< of these cells
  Vec3<T> point;          ///< centre of one of the largest
};

/// The connected regions of the fluid around a solid. Only cells that are certainly free of surface
/// connect; parts that are connected only through cut cells count as separate, so no thin wall
/// leaks.
template <std::floating_point T>
class FluidRegions {
 public:
  explicit FluidRegions(const Octree<T>& mesh);

  /// The regions, largest first.
  [[nodiscard]] std::span<const FluidRegion<T>> regions() const { return regions_; }
  /// The region of a cell of the mesh, given its index in cells(); for a cut cell, the largest
  /// region across one of its faces. kNone: solid, or cut with no fluid at its faces.
  [[nodiscard]] std::uint32_t regionOf(std::size_t cell) const { return regionOf_[cell]; }

  /// Cells of fluid, whole or cut, outside the region that contains the point: those that a
  /// simulation leaves out or covers.
  /// @throws Error if the point is not in the mesh, or in a cell that holds no fluid.
  [[nodiscard]] std::vector<std::size_t> unreached(const Octree<T>& mesh,
                                                   const Vec3<T>& point) const;

 private:
  /// Two cells that share a face, one of them Outside; the second is no finer than the first.
  struct Contact {
    std::uint32_t cell;
    std::uint32_t other;
  };
  /// All contacts of which both cells may be of the fluid.
  [[nodiscard]] static std::vector<Contact> contactsOf(const Octree<T>& mesh);
  /// Numbers the regions: Outside cells of the same set form one region.
  void numberRegions(const Octree<T>& mesh, detail::DisjointSets& sets);
  /// Assigns regions to cut cells, once those of the others are known.
  void assignCutCells(const Octree<T>& mesh, std::span<const Contact> contacts);

  std::vector<FluidRegion<T>> regions_;
  std::vector<std::uint32_t> regionOf_;
};

/// Bounds on the volume of the solid within the mesh's domain, up to round-off of the sums: from
/// the volume of the cells that are certainly inside to that of those not certainly outside.
/// (SolidVolume.hpp computes the volume without a mesh, to any accuracy.)
template <std::floating_point T>
[[nodiscard]] Interval<double> solidVolume(const Octree<T>& mesh);

extern template class FluidRegions<float>;
extern template class FluidRegions<double>;
extern template Interval<double> solidVolume(const Octree<float>&);
extern template Interval<double> solidVolume(const Octree<double>&);

}  // namespace cutwater
