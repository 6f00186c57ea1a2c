#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater::detail {

template <std::floating_point T>
RotationAxis<T>::RotationAxis(const char* name, const Vec3<T>& origin, const Vec3<T>& direction)
    : origin_(origin), direction_(unitVector(name, "axis", direction)) {
  requireFinite(name, "point", origin);
}

template <std::floating_point T>
Box<T> RotationAxis<T>::discBox(T axial, T radius) const {
  const Vec3<T> center = origin_ + axial * direction_;
  const auto& u = direction_;
  // r sqrt(1 - u_i^2), in a form without cancellation for an axis close to i.
  const Vec3<T> reach{std::sqrt(u.y * u.y + u.z * u.z), std::sqrt(u.z * u.z + u.x * u.x),
                      std::sqrt(u.x * u.x + u.y * u.y)};
  return {center - radius * reach, center + radius * reach};
}

template <std::floating_point T>
Box<T> RotationAxis<T>::ballBox(T axial, T radius) const {
  const Vec3<T> center = origin_ + axial * direction_;
  return Box<T>{center, center}.grown(radius);
}

template class RotationAxis<float>;
template class RotationAxis<double>;

}  // namespace cutwater::detail
