#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

namespace cutwater::detail {

/// Unit cells in rows along three axes.
struct CellCounts {
  std::array<std::uint32_t, 3> count;
  /// Whether the last cell of a row is followed by its first, as around a pipe.
  std::array<bool, 3> closed{};
};

/// A strut of one of the cells. Its ends are in units of cells, from the corner of the first.
struct StrutCopy {
  Vec3<double> a, b;
  std::array<std::uint32_t, 2> nodes;  ///< at a and b, as returned by addNode()
};

/// @throws Error, as from `name`, unless there are cells along each axis; of kind Limit if there
/// are more than 2^31 parts, with `parts` for each strut.
void requireFewStruts(const char* name, const UnitCell& cell, const CellCounts& cells,
                      std::uint32_t parts);

/// Adds each node of the struts below once, then visits each strut whose midpoint lies in the
/// closed block of cells, once. Identity is decided by whole numbers: which strut or node of the
/// unit cell it is a copy of, and the cell it is in.
void forEachStrut(const UnitCell& cell, const CellCounts& cells,
                  FunctionRef<std::uint32_t(const Vec3<double>& inCells)> addNode,
                  FunctionRef<void(const StrutCopy&)> visit);

}  // namespace cutwater::detail
