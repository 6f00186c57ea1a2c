#pragma once

#include <Cutwater/Grid/Refinement.hpp>

#include <array>

namespace cutwater::detail {

/// How far some unit vectors differ: an upper bound of the length between any two of them, at most
/// a tenth too large, whatever their order.
template <std::floating_point T>
class DirectionSpread {
 public:
  void add(const Vec3<T>& direction);
  [[nodiscard]] T bound() const;

 private:
  /// Axes, diagonals of faces and of the cube: no direction is farther than 28 degrees from all.
  static constexpr std::size_t kAxes = 13;

  std::array<T, kAxes> least_{};
  std::array<T, kAxes> most_{};
  bool empty_ = true;
};

/// Those of a refinement's rules that ask about the surface within a cell, facet by facet.
template <std::floating_point T>
class FacetRules {
 public:
  /// Both must outlive it.
  FacetRules(const SignedDistanceFunction<T>& solid, const Refinement<T>& rules);

  /// Whether any of them applies to cells of the level.
  [[nodiscard]] bool matter(int level) const;
  /// Whether one asks for a cell of the level to be divided.
  [[nodiscard]] bool ask(int level, const Box<T>& cell);

 private:
  using Facet = SurfaceFacet<T>;

  [[nodiscard]] bool askOf(const Facet& facet, int level) const;
  [[nodiscard]] bool isNarrow(int level, const Box<T>& cell) const;
  [[nodiscard]] static bool face(const Facet& a, const Facet& b, T side, T least);

  const SignedDistanceFunction<T>& solid_;
  const Refinement<T>& rules_;
  T mostTurn_;                 // length between two normals
  T sharpest_;                 // cosine of the angle between two normals
  std::vector<Facet> facets_;  // of the cell
};

extern template class DirectionSpread<float>;
extern template class DirectionSpread<double>;
extern template class FacetRules<float>;
extern template class FacetRules<double>;

}  // namespace cutwater::detail
