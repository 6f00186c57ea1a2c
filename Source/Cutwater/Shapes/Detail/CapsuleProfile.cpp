#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/Profiles.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
CapsuleProfile<T>::CapsuleProfile(const char* name, const Vec3<T>& a, const Vec3<T>& b, T radius)
    : length_(distanceBetween(a, b)), radius_(radius) {
  if (radius > 0 && std::isfinite(radius)) return;
  const std::string message = std::string(name) + ": need 0 < radius < infinity";
  require(false, message.c_str(), Named{"radius", radius});
}

template <std::floating_point T>
ProfilePoint<T> CapsuleProfile<T>::fromSegment(const ProfilePoint<T>& p) const {
  return {p.radial, p.axial - std::clamp(p.axial, T(0), length_)};
}

template <std::floating_point T>
T CapsuleProfile<T>::distance(const ProfilePoint<T>& p) const {
  return length(fromSegment(p)) - radius_;
}

template <std::floating_point T>
ProfilePoint<T> CapsuleProfile<T>::gradient(const ProfilePoint<T>& p) const {
  // On the segment itself the direction is radial, and undefined.
  const bool beside = 0 < p.axial && p.axial < length_;
  return beside ? ProfilePoint<T>{1, 0} : normalized(fromSegment(p));
}

template <std::floating_point T>
Box<T> CapsuleProfile<T>::box(const RotationAxis<T>& axis) const {
  return axis.ballBox(0, radius_).extend(axis.ballBox(length_, radius_));
}

template class CapsuleProfile<float>;
template class CapsuleProfile<double>;

}  // namespace cutwater::detail
