#pragma once

#include <Cutwater/Grid/Detail/CellTagger.hpp>
#include <Cutwater/Grid/Detail/FacetTree.hpp>

#include <array>

namespace cutwater::detail {

/// Spread of a set of unit vectors: an upper bound on the distance between any two of them, at most
/// 13 % too large, whatever the order in which they are added.
template <std::floating_point T>
class DirectionSpread {
 public:
  void add(const Vec3<T>& direction);
  [[nodiscard]] T bound() const;

 private:
  /// The axes x, y and z, then the diagonals of the faces and of the cube: every direction is
  /// within 28 degrees of one of them.
  static constexpr std::size_t kAxes = 13;

  std::array<T, kAxes> least_{};
  std::array<T, kAxes> most_{};
  bool empty_ = true;
};

/// The rules of a refinement that depend on the surface within a cell, facet by facet.
template <std::floating_point T>
class FacetRules {
 public:
  /// Both must outlive it.
  FacetRules(const SignedDistanceFunction<T>& solid, const Refinement<T>& rules);

  /// Whether any of the rules applies to cells of the level.
  [[nodiscard]] bool concern(int level) const;
  /// Tags cells of the level for refinement, among those that the surface may meet and no other
  /// rule divides. Most efficient if consecutive cells are neighbours.
  void tag(int level, std::span<const Box<T>> cells, std::span<CellTag> tags);

 private:
  using Facet = SurfaceFacet<T>;
  using Width = std::optional<typename Refinement<T>::Width>;
  /// Number of neighbours along an axis whose surrounding facets are looked up together.
  static constexpr T kTogether = 8;
  /// As a fraction of a cell's width: normally larger than the round-off in coordinates.
  static constexpr T kMargin = T(0x1p-10);

  [[nodiscard]] static bool isOpen(const CellTag& tag) {
    return mayBeCut(tag.kind) && !tag.isRefined;
  }
  /// Applies the rules to the facets in the cell, and keeps these.
  [[nodiscard]] bool applyWithin(int level, const Box<T>& cell);
  [[nodiscard]] bool appliesTo(const Facet& facet, int level) const;
  /// The largest number of cells that the rules on gaps and walls require at the level; negative if
  /// none applies.
  [[nodiscard]] T reachOf(int level) const;
  /// Stores the facets around the first of the cells and as many of the next ones as are near.
  void lookAround(T reach, std::span<const Box<T>> cells, std::span<const CellTag> tags);
  [[nodiscard]] bool isNarrow(const Width& rule, Facing facing, int level, const Box<T>& cell);
  /// The same for the facets that facetsIn() visits in a box around the cell.
  [[nodiscard]] bool seesFacing(const Box<T>& region, Facing facing, T least);

  const SignedDistanceFunction<T>& solid_;
  const Refinement<T>& rules_;
  T mostTurn_ = 2;             // distance between two normals
  T sharpest_ = -1;            // cosine of the angle between two normals
  FacetTree<T> own_;           // facets of the cell
  DirectionSpread<T> spread_;  // of their normals
  Box<T> surroundings_;        // region around some cells
  bool isAllAround_ = false;   // all facets there are in around_
  FacetTree<T> around_;
  FacetTree<T> other_;  // one of them
};

extern template class DirectionSpread<float>;
extern template class DirectionSpread<double>;
extern template class FacetRules<float>;
extern template class FacetRules<double>;

}  // namespace cutwater::detail
