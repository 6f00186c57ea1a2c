#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

template <std::floating_point T>
T Axisymmetric<T>::localSignedDistance(const Vec3<T>& p) const {
  return profileDistance(axis_.profilePoint(p));
}

template <std::floating_point T>
Vec3<T> Axisymmetric<T>::localGradient(const Vec3<T>& p) const {
  const auto split = axis_.split(p);
  return axis_.revolved(split, profileGradient({length(split.radial), split.axial}));
}

template class Axisymmetric<float>;
template class Axisymmetric<double>;

}  // namespace cutwater
