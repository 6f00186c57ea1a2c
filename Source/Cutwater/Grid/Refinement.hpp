#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
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
  /// Cells that may have a point within this distance of the surface, by distanceBounds(); all
  /// cells if the guarantee says nothing about distances.
  std::vector<Band> bands{};
  /// Cells that a patch meets, in addition to `cut`.
  std::vector<Patch> patches{};
  /// Cells in which normals differ by more than the angle. Some cells with a smaller difference are
  /// divided, too: down to 6/7 of the angle, or 2/3 of it near 180 degrees.
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

extern template struct Refinement<float>;
extern template struct Refinement<double>;

}  // namespace cutwater
