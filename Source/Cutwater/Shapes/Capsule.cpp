#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Direction.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Capsule<T>::Capsule(const Vec3<T>& a, const Vec3<T>& b, T radius)
    : Axisymmetric<T>("Capsule", a, a == b ? Vec3<T>{0, 0, 1} : b - a),
      radius_(radius),
      length_(detail::distanceBetween(a, b)),
      size_(detail::farther(a, b) + radius) {
  require(radius > 0 && std::isfinite(radius), "Capsule: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
ProfilePoint<T> Capsule<T>::fromSegment(const ProfilePoint<T>& p) const {
  return {p.radial, p.axial - std::clamp(p.axial, T(0), length_)};
}

template <std::floating_point T>
T Capsule<T>::profileDistance(const ProfilePoint<T>& p) const {
  return length(fromSegment(p)) - radius_;
}

template <std::floating_point T>
ProfilePoint<T> Capsule<T>::profileGradient(const ProfilePoint<T>& p) const {
  // On the segment itself the direction is radial, and undefined.
  const bool beside = 0 < p.axial && p.axial < length_;
  return beside ? ProfilePoint<T>{1, 0} : normalized(fromSegment(p));
}

template <std::floating_point T>
Guarantee<T> Capsule<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> Capsule<T>::localBoundingBox() const {
  return localGuarantee().grown(this->ballBox(0, radius_).extend(this->ballBox(length_, radius_)));
}

template class Capsule<float>;
template class Capsule<double>;

}  // namespace cutwater
