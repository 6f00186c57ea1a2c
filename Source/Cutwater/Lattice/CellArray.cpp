#include <Cutwater/Lattice/CellArray.hpp>

namespace cutwater {

template <std::floating_point T>
CellArray<T>::CellArray(UnitCell cell, const Repeats<T>& cells, Thickness<T> thickness)
    : StrutLattice<T>(std::move(cell), cells, std::move(thickness)) {}

template class CellArray<float>;
template class CellArray<double>;

}  // namespace cutwater
