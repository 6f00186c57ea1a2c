#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Axisymmetric.hpp>
#include <Cutwater/Shapes/Direction.hpp>

namespace cutwater {

template <std::floating_point T>
Axisymmetric<T>::Axisymmetric(const char* name, const Vec3<T>& origin, const Vec3<T>& axis)
    : origin_(origin), axis_(detail::unitVector(name, "axis", axis)) {
  detail::requireFinite(name, "point", origin);
}

template <std::floating_point T>
auto Axisymmetric<T>::split(const Vec3<T>& p) const -> Split {
  const Vec3<T> d = p - origin_;
  const T axial = dot(d, axis_);
  return {axial, d - axial * axis_};
}

template <std::floating_point T>
T Axisymmetric<T>::localSignedDistance(const Vec3<T>& p) const {
  const auto [axial, radial] = split(p);
  return profileDistance({length(radial), axial});
}

template <std::floating_point T>
Vec3<T> Axisymmetric<T>::localGradient(const Vec3<T>& p) const {
  const auto [axial, radial] = split(p);
  const T distance = length(radial);
  const auto g = profileGradient({distance, axial});
  if (g.radial == 0) return g.axial * axis_;
  if (!(distance > 0)) return {};  // equally steep in every direction away from the axis
  return (g.radial / distance) * radial + g.axial * axis_;
}

template <std::floating_point T>
Box<T> Axisymmetric<T>::discBox(T axial, T radius) const {
  const Vec3<T> center = origin_ + axial * axis_;
  const auto& u = axis_;
  // r sqrt(1 - u_i^2), in a form that does not cancel for an axis close to i.
  const Vec3<T> reach{std::sqrt(u.y * u.y + u.z * u.z), std::sqrt(u.z * u.z + u.x * u.x),
                      std::sqrt(u.x * u.x + u.y * u.y)};
  return {center - radius * reach, center + radius * reach};
}

template <std::floating_point T>
Box<T> Axisymmetric<T>::ballBox(T axial, T radius) const {
  const Vec3<T> center = origin_ + axial * axis_;
  return Box<T>{center, center}.grown(radius);
}

template class Axisymmetric<float>;
template class Axisymmetric<double>;

}  // namespace cutwater
