#include <Cutwater/Lattice/CellArray.hpp>

namespace cutwater {

template <std::floating_point T>
CellArray<T>::CellArray(UnitCell cell, const Repeats<T>& cells, T radius)
    : StrutLattice<T>("CellArray", std::move(cell), cells, radius) {}

template class CellArray<float>;
template class CellArray<double>;

}  // namespace cutwater
