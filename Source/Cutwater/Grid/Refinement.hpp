#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/MortonCode.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <span>
#include <vector>

namespace cutwater {

/// The rules by which a mesh is refined, each with a level: 0 is the coarsest, and cells of each
/// further level are half as wide. A cell coarser than a rule's level is divided if that rule
/// applies to it; one rule is enough.
///
/// All rules except the bands apply to cells that the surface may meet: see BoxClass. Rules on
/// facets of the surface see all of them for meshes, their motions, unions, intersections and
/// complements; for other solids they see samples: see SignedDistanceFunction::facetsIn().
template <std::floating_point T>
struct Refinement {
  struct Band {
    T distance;  ///< to the surface, in units of length
    int level;
  };
  struct Patch {
    std::uint32_t patch;  ///< index in patchNames()
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

  /// Level of cells that the surface certainly or possibly meets.
  int cut = 0;
  /// Cells with a point within a distance of the surface, unless distanceBounds() rules that out:
  /// all cells where the solid's guarantee says nothing about distances.
  std::vector<Band> bands{};
  /// Cells that a patch meets, in addition to `cut`.
  std::vector<Patch> patches{};
  /// Cells in which normals differ by more than the angle; also some in which they differ by up to
  /// a seventh less, or up to a third less if the angle is near 180 degrees.
  std::optional<Angle> curvature{};
  /// Cells that meet an edge at which the surface bends by more than the angle.
  std::optional<Angle> edges{};
  /// Cells from which another sheet that faces this one, within 60 degrees, is fewer than `cells`
  /// cells away: gaps with too few cells across. Cells are counted along the axes.
  std::optional<Width> gaps{};
  /// The same for walls: the sheets stand back to back.
  std::optional<Width> walls{};

  /// The finest level of any rule.
  [[nodiscard]] int deepest() const;
  /// @throws Error if a level is negative, or a distance or width is negative or not finite, or an
  /// angle is not within (0, 180).
  void check() const;
};

/// The decision about a cell.
struct CellVerdict {
  BoxClass kind = BoxClass::Unknown;
  bool isRefined = false;
};

/// Decides which cells are refined. The verdict on a cell depends on that cell alone, not on which
/// others are judged or by whom, so the marks of patches, octrees and ranks agree.
template <std::floating_point T>
class CellJudge {
 public:
  /// Both must outlive it. @throws Error as Refinement::check().
  CellJudge(const SignedDistanceFunction<T>& solid, const Refinement<T>& refinement);

  /// Judges at most kMost cells of one level. On entry, hints are of boxes around the cells; on
  /// return, of the cells themselves.
  void judge(int level, std::span<const Box<T>> cells, std::span<BoxHint> hints,
             std::span<CellVerdict> verdicts) const;
  static constexpr std::size_t kMost = 256;

  /// Cells of one level, with callbacks for the hints of the cells from `first` on: hintsBefore
  /// supplies hints of boxes around the cells, hintsAfter receives those of the cells themselves.
  struct Cells {
    int level = 0;
    Level<T> grid;
    std::span<const MortonCode> codes;
    FunctionRef<void(std::size_t first, std::span<BoxHint>)> hintsBefore;
    FunctionRef<void(std::size_t first, std::span<const BoxHint>)> hintsAfter;
  };
  /// Judges any number of cells, in parallel; see parallelFor(). Several threads call the
  /// callbacks, for ranges that have no cell in common.
  void judge(const Cells& cells, std::span<CellVerdict> verdicts,
             const ParallelOptions& options) const;

 private:
  /// Distance from the surface within which cells of the level are refined; negative if they are
  /// not.
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
