#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cutwater {

/// Where a box is among grids.
struct BoxPlace {
  std::size_t grid = 0;
  Index3 cell;
};

/// Grids of which boxes are cells, some of them perhaps cells of no box.
struct BoxGrids {
  std::vector<CellPlanes> grids;
  std::vector<BoxPlace> places;  ///< of each box
};

/// The boxes that are cells of a host's mesh as cells of small grids, for a CellCutter or a
/// SolidCutter: of up to 8 cells along each axis, so that few cells are cut in vain where a level
/// has but some of those between its planes.
///
/// @param boxes  in any order.
/// @param levels  of each box. Boxes of one level must be those between planes that all of them
/// share; where they are rounded differently, by less than 1e-9 of their width, the lowest count.
/// @throws Error(Argument) for other boxes, and unless there are as many levels.
[[nodiscard]] BoxGrids gridsOf(std::span<const Box<double>> boxes, std::span<const int> levels);

/// A host's domain of equal cells.
struct HostDomain {
  IndexBox cells;       ///< in 2D, one layer
  Vec3<double> origin;  ///< the lower corner of the cell of index 0
  Vec3<double> width;   ///< of a cell
  std::array<bool, 3> isPeriodic = {};
  bool isPlane = false;  ///< in 2D: of the plane at `z`
  double z = 0;

  /// The number of axes along which it has cells.
  [[nodiscard]] int dimensions() const { return isPlane ? 2 : 3; }
};

/// The planes between the cells of a domain; in 2D, those of a layer 1 thick across z.
[[nodiscard]] std::array<std::vector<double>, 3> planesOf(const HostDomain& domain);

/// The cells of a domain.
/// @param cutter  a CellCutter or a SolidCutter: with a period along axes in which the domain is
/// periodic, as long as it is, and none along others.
/// @param domain  see there.
/// @param options  in 2D without polygons.
/// @throws Error(Argument) for another period, for any in 2D, and as cutting does.
template <typename Cutter>
[[nodiscard]] CutCells cellsOf(const Cutter& cutter, const HostDomain& domain,
                               const CutOptions& options = {}) {
  for (int axis = 0; axis < domain.dimensions(); ++axis) {
    require(domain.isPeriodic[static_cast<std::size_t>(axis)] == (cutter.period()[axis] > 0),
            "cellsOf: need a cutter with a period where the domain has one", Named{"axis", axis});
  }
  const auto planes = planesOf(domain);
  const auto& first = domain.cells.lo;
  if (domain.isPlane) return cutter.cutInPlane(cellsBetween(planes, first), domain.z, options);
  return cutter.cut(cutter.cellsOfPeriod(planes, first, domain.cells), options);
}

}  // namespace cutwater
