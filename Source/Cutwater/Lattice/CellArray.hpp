#pragma once

#include <Cutwater/Lattice/StrutLattice.hpp>

namespace cutwater {

/// An array of unit cells in a box from the origin: all struts whose midpoints lie in the closed
/// box.
///
/// The same solid as explicit beams for each strut (see BeamGraph), whatever the number of cells:
/// at its ends, struts are round, not cut off. Endless along axes whose count is 0.
///
/// @throws Error unless sizes are positive and of ordinary magnitude; of kind Limit beyond 2^20
/// cells along an axis.
template <std::floating_point T>
class CellArray final : public StrutLattice<T> {
 public:
  CellArray(UnitCell cell, const Repeats<T>& cells, Thickness<T> thickness);
};

extern template class CellArray<float>;
extern template class CellArray<double>;

}  // namespace cutwater
