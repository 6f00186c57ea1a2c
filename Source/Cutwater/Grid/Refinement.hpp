#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// What a mesh generator refines, and to which level: 0 is the coarsest, and cells of each further
/// level are half as wide. A cell of a level below is divided as soon as one rule asks for it.
template <std::floating_point T>
struct Refinement {
  struct Band {
    T distance;  ///< to the surface, in units of length
    int level;
  };

  /// Of cells that the surface meets, certainly or possibly: see BoxClass.
  int cut = 0;
  /// Of cells with a point within a distance of the surface, as far as distanceBounds() can rule it
  /// out: all cells where the solid's guarantee tells nothing of distances.
  std::vector<Band> bands = {};

  /// The finest level that is asked for.
  [[nodiscard]] int deepest() const;
  /// @throws Error if a level is negative or a distance negative or not finite.
  void check() const;
};

/// What is decided about a cell.
struct CellVerdict {
  BoxClass kind = BoxClass::Unknown;
  bool isRefined = false;
};

/// Decides about cells one by one: the same for the same cell, whatever is asked about others, and
/// by whom. So the marks of patches, octrees and ranks agree.
template <std::floating_point T>
class CellJudge {
 public:
  /// Both must outlive it. @throws Error as Refinement::check().
  CellJudge(const SignedDistanceFunction<T>& solid, const Refinement<T>& refinement);

  /// Of at most kMost cells of one level. Hints are of boxes around the cells at first, of the
  /// cells in the end.
  void judge(int level, std::span<const Box<T>> cells, std::span<BoxHint> hints,
             std::span<CellVerdict> verdicts) const;
  static constexpr std::size_t kMost = 256;

 private:
  /// How near to the surface cells of the level are refined; negative if they are not.
  [[nodiscard]] T reachOf(int level) const;
  void judgeNearness(T reach, std::span<const Box<T>> cells, std::span<BoxHint> hints,
                     std::span<CellVerdict> verdicts) const;
  [[nodiscard]] bool isNear(T reach, const Box<T>& cell, T atCenter, BoxHint& hint) const;

  const SignedDistanceFunction<T>& solid_;
  const Refinement<T>& refinement_;
  Guarantee<T> promise_;
};

extern template struct Refinement<float>;
extern template struct Refinement<double>;
extern template class CellJudge<float>;
extern template class CellJudge<double>;

}  // namespace cutwater
