#pragma once

#include <Cutwater/Lattice/StrutLattice.hpp>

namespace cutwater {

/// A lattice without end: unit cells of this size at all multiples of it.
///
/// The library chooses how: by folding, in a few nanoseconds, where the cell has mirrors (see
/// CellFold), and equal sizes along the axes that they exchange; otherwise by a search of
/// neighbouring cells.
///
/// @throws Error unless sizes are positive and ordinary.
template <std::floating_point T>
class PeriodicLattice final : public StrutLattice<T> {
 public:
  PeriodicLattice(UnitCell cell, const Vec3<T>& size, Thickness<T> thickness);
};

extern template class PeriodicLattice<float>;
extern template class PeriodicLattice<double>;

}  // namespace cutwater
