#include <Cutwater/Shapes/Axisymmetric.hpp>

namespace cutwater {

template <std::floating_point T>
T Axisymmetric<T>::localSignedDistance(const Vec3<T>& p) const {
  return profileDistance(axis_.profilePoint(p));
}

template <std::floating_point T>
Vec3<T> Axisymmetric<T>::localGradient(const Vec3<T>& p) const {
  const auto [axial, radial] = axis_.split(p);
  const T distance = length(radial);
  const auto g = profileGradient({distance, axial});
  if (g.radial == 0) return g.axial * axis();
  if (!(distance > 0)) return {};  // equally steep in every direction away from the axis
  return (g.radial / distance) * radial + g.axial * axis();
}

template class Axisymmetric<float>;
template class Axisymmetric<double>;

}  // namespace cutwater
