#include <Cutwater/Lattice/PeriodicLattice.hpp>

namespace cutwater {

template <std::floating_point T>
PeriodicLattice<T>::PeriodicLattice(UnitCell cell, const Vec3<T>& size, T radius)
    : StrutLattice<T>("PeriodicLattice", std::move(cell), {.period = size}, radius) {}

template class PeriodicLattice<float>;
template class PeriodicLattice<double>;

}  // namespace cutwater
