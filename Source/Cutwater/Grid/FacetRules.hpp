#pragma once

#include <Cutwater/Grid/FacetTree.hpp>
#include <Cutwater/Grid/Refinement.hpp>

#include <array>

namespace cutwater::detail {

/// How far some unit vectors differ: an upper bound of the length between any two of them, at most
/// 13 % too large, whatever their order.
template <std::floating_point T>
class DirectionSpread {
 public:
  void add(const Vec3<T>& direction);
  [[nodiscard]] T bound() const;

 private:
  /// Axes, x, y and z first, diagonals of faces and of the cube: no direction is farther than 28
  /// degrees from all.
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
  /// Asks for some of the cells of the level to be divided, of those that the surface may meet and
  /// no other rule divides. Best for neighbours, one after the other.
  void ask(int level, std::span<const Box<T>> cells, std::span<CellVerdict> verdicts);

 private:
  using Facet = SurfaceFacet<T>;
  using Width = std::optional<typename Refinement<T>::Width>;
  /// Neighbours for which facets around them are looked up together, along an axis.
  static constexpr T kTogether = 8;
  /// Of a cell's width: larger than what is rounding in coordinates, as a rule.
  static constexpr T kMargin = T(0x1p-10);

  [[nodiscard]] static bool isOpen(const CellVerdict& verdict) {
    return mayBeCut(verdict.kind) && !verdict.isRefined;
  }
  /// By the facets in the cell, which are kept.
  [[nodiscard]] bool askWithin(int level, const Box<T>& cell);
  [[nodiscard]] bool askOf(const Facet& facet, int level) const;
  /// Of cells of the level, the largest number of gaps and walls; negative if there is none.
  [[nodiscard]] T reachOf(int level) const;
  /// Keeps the facets around the first of some cells and as many of the next ones as are near.
  void lookAround(T reach, std::span<const Box<T>> cells, std::span<const CellVerdict> verdicts);
  [[nodiscard]] bool isNarrow(const Width& rule, Facing facing, int level, const Box<T>& cell);
  /// The same by what facetsIn() shows of a box around the cell.
  [[nodiscard]] bool seesFacing(const Box<T>& region, Facing facing, T least);

  const SignedDistanceFunction<T>& solid_;
  const Refinement<T>& rules_;
  T mostTurn_ = 2;             // length between two normals
  T sharpest_ = -1;            // cosine of the angle between two normals
  FacetTree<T> own_;           // facets of the cell
  DirectionSpread<T> spread_;  // of their normals
  Box<T> surroundings_;        // of some cells
  bool isAllAround_ = false;   // all facets there are known:
  FacetTree<T> around_;
  FacetTree<T> other_;  // one of them
};

extern template class DirectionSpread<float>;
extern template class DirectionSpread<double>;
extern template class FacetRules<float>;
extern template class FacetRules<double>;

}  // namespace cutwater::detail
