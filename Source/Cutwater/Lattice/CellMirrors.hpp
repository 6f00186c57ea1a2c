#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// A straight strut between two points, in units of the unit cell.
struct CellStrut {
  Vec3<double> a, b;

  /// Half-way between its ends.
  [[nodiscard]] Vec3<double> middle() const { return 0.5 * (a + b); }
};

/// Mirrors that a lattice may have, as a rule by which points are folded into one chamber between
/// them. A fold never moves two points apart, and so the strut nearest to a folded point has an
/// image in the chamber: what is there tells the distance to all of the endless lattice.
enum class CellFold : std::uint8_t {
  None,
  Octant,  ///< planes through faces and middles of cells: x, y, z in [0, 1/2]
  SortXY,  ///< and x = y: y <= x
  Sort,    ///< and y = z: z <= y <= x
  /// The planes x +- y = n / 2 and so on, of the diamond, whose points repeat on a face-centred
  /// lattice: |z| <= y <= x, x + y <= 1/2 (the alcove of the affine Weyl group A3).
  Fcc,
};

namespace detail {

/// A side of the chamber: normal . x >= offset in it, and a mirror of the lattice.
struct ChamberWall {
  Vec3<double> normal;
  double offset;

  [[nodiscard]] double height(const Vec3<double>& x) const { return dot(normal, x) - offset; }
  [[nodiscard]] Vec3<double> image(const Vec3<double>& x) const {
    return x - (2 * height(x) / lengthSquared(normal)) * normal;
  }
};
[[nodiscard]] std::span<const ChamberWall> wallsOf(CellFold fold);

/// What lies in the chamber of one strut of the lattice.
struct ChamberStrut {
  CellStrut part;
  std::uint32_t strut;  ///< index of the strut that the whole is a copy of
  Vec3<double> middle;  ///< of the whole
};

/// All that lies in the chamber of copies of the struts, which are those of a UnitCell, in all
/// cells. Not for CellFold::None.
[[nodiscard]] std::vector<ChamberStrut> strutsInChamber(std::span<const CellStrut> struts,
                                                        CellFold fold);

}  // namespace detail

}  // namespace cutwater
