#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Grid/Octree.hpp>

namespace cutwater {

namespace detail {
class DisjointSets;
}  // namespace detail

/// A part of the fluid that Outside cells form across their faces.
template <std::floating_point T>
struct FluidRegion {
  std::size_t cells = 0;  ///< Outside ones
  double volume = 0;      ///< of those
  Vec3<T> point;          ///< centre of one of the largest
};

/// The fluid around a solid, as far as cells that are certainly free of surface connect it: what
/// only cut cells connect counts as apart, so no thin wall leaks.
template <std::floating_point T>
class FluidRegions {
 public:
  explicit FluidRegions(const Octree<T>& mesh);

  /// The largest first.
  [[nodiscard]] std::span<const FluidRegion<T>> regions() const { return regions_; }
  /// The region of a cell of the mesh, by its place; of a cell that is cut, the largest across one
  /// of its faces. kNone: solid, or cut with no fluid at its faces.
  [[nodiscard]] std::uint32_t regionOf(std::size_t cell) const { return regionOf_[cell]; }

  /// Cells of fluid, whole or cut, that are not of the region that holds the point: what a
  /// simulation leaves out, or covers.
  /// @throws Error if the point is not in the mesh, or in a cell that is not of the fluid.
  [[nodiscard]] std::vector<std::size_t> unreached(const Octree<T>& mesh,
                                                   const Vec3<T>& point) const;

 private:
  /// Cells across a face, one Outside; the second is no finer than the first.
  struct Contact {
    std::uint32_t cell;
    std::uint32_t other;
  };
  /// All of which both cells may be of the fluid.
  [[nodiscard]] static std::vector<Contact> contactsOf(const Octree<T>& mesh);
  /// Outside cells of the same set are of one region.
  void numberRegions(const Octree<T>& mesh, detail::DisjointSets& sets);
  /// Of cells that are cut, once those of the others are known.
  void assignCutCells(const Octree<T>& mesh, std::span<const Contact> contacts);

  std::vector<FluidRegion<T>> regions_;
  std::vector<std::uint32_t> regionOf_;
};

/// Encloses the volume of the solid within the mesh's domain, up to the rounding of sums: from the
/// cells that are certainly inside to those that are not certainly outside. (SolidVolume.hpp has
/// the volume without a mesh, as closely as one wants.)
template <std::floating_point T>
[[nodiscard]] Interval<double> solidVolume(const Octree<T>& mesh);

extern template class FluidRegions<float>;
extern template class FluidRegions<double>;
extern template Interval<double> solidVolume(const Octree<float>&);
extern template Interval<double> solidVolume(const Octree<double>&);

}  // namespace cutwater
