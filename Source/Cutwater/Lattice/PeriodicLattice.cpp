#include <Cutwater/Lattice/PeriodicLattice.hpp>

namespace cutwater {

template <std::floating_point T>
PeriodicLattice<T>::PeriodicLattice(UnitCell cell, const Vec3<T>& size, Thickness<T> thickness)
    : StrutLattice<T>(std::move(cell), {.period = size}, std::move(thickness)) {}

template class PeriodicLattice<float>;
template class PeriodicLattice<double>;

}  // namespace cutwater
