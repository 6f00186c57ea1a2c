#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/RingConcavity.hpp>
#include <Cutwater/Shapes/Torus.hpp>

namespace cutwater {

template <std::floating_point T>
Torus<T>::Torus(const Vec3<T>& center, const Vec3<T>& axis, T major, T minor)
    : Axisymmetric<T>("Torus", center, axis), major_(major), minor_(minor) {
  require(0 < minor && minor < major && std::isfinite(major),
          "Torus: need 0 < minor < major < infinity", Named{"minor", minor}, Named{"major", major});
}

template <std::floating_point T>
T Torus<T>::profileDistance(const ProfilePoint<T>& p) const {
  const T ring = p.radial - major_;
  return std::sqrt(ring * ring + p.axial * p.axial) - minor_;
}

template <std::floating_point T>
ProfilePoint<T> Torus<T>::profileGradient(const ProfilePoint<T>& p) const {
  return normalized(ProfilePoint<T>{p.radial - major_, p.axial});
}

template <std::floating_point T>
std::optional<T> Torus<T>::localConcavity(const OrientedBox<T>& box) const {
  return detail::concavityAround(this->rotationAxis().profilePoint(box.center).radial, box,
                                 localGuarantee());
}

template <std::floating_point T>
Guarantee<T> Torus<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(this->origin()) + major_ + minor_);
}

template <std::floating_point T>
Box<T> Torus<T>::localBoundingBox() const {
  return localGuarantee().grown(this->rotationAxis().discBox(0, major_).grown(minor_));
}

template class Torus<float>;
template class Torus<double>;

}  // namespace cutwater
