#pragma once

#include <Cutwater/Lattice/StrutLattice.hpp>

namespace cutwater {

/// An endless lattice: unit cells of this size at all multiples of it.
///
/// Distances are found by folding, in a few nanoseconds, if the cell has mirrors (see CellFold) and
/// equal sizes along the axes that they exchange; otherwise by a search of neighbouring cells.
///
/// @throws Error unless sizes are positive and of ordinary magnitude.
template <std::floating_point T>
class PeriodicLattice final : public StrutLattice<T> {
 public:
  PeriodicLattice(UnitCell cell, const Vec3<T>& size, Thickness<T> thickness);
};

extern template class PeriodicLattice<float>;
extern template class PeriodicLattice<double>;

}  // namespace cutwater
