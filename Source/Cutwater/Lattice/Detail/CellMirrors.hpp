#pragma once

#include <Cutwater/Lattice/UnitCell.hpp>

namespace cutwater::detail {

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

}  // namespace cutwater::detail
