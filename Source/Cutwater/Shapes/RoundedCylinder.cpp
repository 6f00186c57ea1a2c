#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/BoxDistance.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
RoundedCylinder<T>::RoundedCylinder(const Vec3<T>& a, const Vec3<T>& b, T radius, T rounding)
    : Axisymmetric<T>("RoundedCylinder", a, b - a),
      length_(detail::distanceBetween(a, b)),
      rounding_(rounding),
      coreRadius_(radius - rounding),
      size_(detail::farther(a, b) + radius),
      section_(detail::rectangle(coreRadius_, rounding, std::max(rounding, length_ - rounding))) {
  require(radius > 0 && std::isfinite(radius), "RoundedCylinder: need 0 < radius < infinity",
          Named{"radius", radius});
  require(rounding > 0 && rounding <= radius && rounding <= T(0.5) * length_,
          "RoundedCylinder: need 0 < rounding <= radius and half the length",
          Named{"rounding", rounding}, Named{"radius", radius}, Named{"length", length_});
}

template <std::floating_point T>
T RoundedCylinder<T>::profileDistance(const ProfilePoint<T>& p) const {
  return detail::boxDistance(section_, {p.radial, p.axial, 0}) - rounding_;
}

template <std::floating_point T>
ProfilePoint<T> RoundedCylinder<T>::profileGradient(const ProfilePoint<T>& p) const {
  const auto g = detail::boxGradient(section_, {p.radial, p.axial, 0});
  return {g.x, g.y};
}

template <std::floating_point T>
Guarantee<T> RoundedCylinder<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> RoundedCylinder<T>::localBoundingBox() const {
  auto core = this->rotationAxis().discBox(section_.lower.y, coreRadius_);
  core.extend(this->rotationAxis().discBox(section_.upper.y, coreRadius_));
  return localGuarantee().grown(core.grown(rounding_));
}

template class RoundedCylinder<float>;
template class RoundedCylinder<double>;

}  // namespace cutwater
