#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// A straight strut between two points, in units of the unit cell.
struct CellStrut {
  Vec3<double> a, b;

  /// The point half-way between its ends.
  [[nodiscard]] Vec3<double> middle() const { return 0.5 * (a + b); }
};

/// Mirrors that a lattice may have, given as a rule that folds points into one chamber between
/// them. A fold never moves two points apart, so the strut nearest to a folded point has an image
/// in the chamber: what is there determines the distance to the whole endless lattice.
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

/// Coordinates in units of the cell that differ by less are equal but for rounding.
constexpr double kRounding = 0x1p-50;

/// A side of the chamber, and a mirror of the lattice: normal . x >= offset in the chamber.
struct ChamberWall {
  Vec3<double> normal;
  double offset;

  [[nodiscard]] double height(const Vec3<double>& x) const { return dot(normal, x) - offset; }
  [[nodiscard]] Vec3<double> image(const Vec3<double>& x) const {
    return x - (2 * height(x) / lengthSquared(normal)) * normal;
  }
};
[[nodiscard]] std::span<const ChamberWall> wallsOf(CellFold fold);

/// The part of one strut of the lattice that lies in the chamber.
struct ChamberStrut {
  CellStrut part;
  std::uint32_t strut;  ///< index of the strut of which the whole is a copy
  Vec3<double> middle;  ///< of the whole strut
};

/// The parts that lie in the chamber of all copies, in all cells, of a UnitCell's struts. Not for
/// CellFold::None.
[[nodiscard]] std::vector<ChamberStrut> strutsInChamber(std::span<const CellStrut> struts,
                                                        CellFold fold);

}  // namespace detail

}  // namespace cutwater
