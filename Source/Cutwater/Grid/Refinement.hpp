#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/MortonCode.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <span>
#include <vector>

namespace cutwater {

/// What a mesh generator refines, and to which level: 0 is the coarsest, and cells of each further
/// level are half as wide. A cell of a level below is divided as soon as one rule asks for it.
///
/// All but the bands are about cells that the surface may meet: see BoxClass. What they say of its
/// facets is complete for meshes, their motions, unions, intersections and complements; of other
/// solids they see samples: see SignedDistanceFunction::facetsIn().
template <std::floating_point T>
struct Refinement {
  struct Band {
    T distance;  ///< to the surface, in units of length
    int level;
  };
  struct Patch {
    std::uint32_t patch;  ///< of patchNames()
    int level;
  };
  struct Angle {
    T degrees;
    int level;
  };
  struct Width {
    T cells;
    int level;
  };

  /// Of cells that the surface meets, certainly or possibly.
  int cut = 0;
  /// Of cells with a point within a distance of the surface, as far as distanceBounds() can rule it
  /// out: all cells where the solid's guarantee tells nothing of distances.
  std::vector<Band> bands{};
  /// Of cells that a patch meets, beyond `cut`.
  std::vector<Patch> patches{};
  /// Of cells in which normals differ by more than the angle; of some that differ by a seventh less
  /// than it, or by a third less if it is near 180 degrees.
  std::optional<Angle> curvature{};
  /// Of cells that meet an edge at which the surface bends by more than the angle.
  std::optional<Angle> edges{};
  /// Of cells from which another sheet that faces this one, within 60 degrees, is fewer cells away:
  /// gaps with too few cells across. Cells are counted along axes.
  std::optional<Width> gaps{};
  /// The same for walls: the sheets stand back to back.
  std::optional<Width> walls{};

  /// The finest level that is asked for.
  [[nodiscard]] int deepest() const;
  /// @throws Error if a level is negative, or a distance or width is negative or not finite, or an
  /// angle is not within (0, 180).
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

  /// Cells of one level, and where hints come from and go: to be told for the cells from `first`
  /// on, and told of them. Those before are of boxes around the cells.
  struct Cells {
    int level = 0;
    Level<T> grid;
    std::span<const MortonCode> codes;
    FunctionRef<void(std::size_t first, std::span<BoxHint>)> hintsBefore;
    FunctionRef<void(std::size_t first, std::span<const BoxHint>)> hintsAfter;
  };
  /// Of any number of cells, in parallel; see parallelFor(). Hints are asked for and told by
  /// several threads, for stretches that have no cell in common.
  void judge(const Cells& cells, std::span<CellVerdict> verdicts,
             const ParallelOptions& options) const;

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
