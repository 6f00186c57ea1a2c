#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
Capsule<T>::Capsule(const Vec3<T>& a, const Vec3<T>& b, T radius)
    : Axisymmetric<T>(detail::RotationAxis<T>::between("Capsule", a, b)),
      profile_("Capsule", a, b, radius),
      size_(detail::farther(a, b) + radius) {}

template <std::floating_point T>
T Capsule<T>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_.distance(p);
}

template <std::floating_point T>
ProfilePoint<T> Capsule<T>::profileGradient(const ProfilePoint<T>& p) const {
  return profile_.gradient(p);
}

template <std::floating_point T>
Guarantee<T> Capsule<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> Capsule<T>::localBoundingBox() const {
  return localGuarantee().grown(profile_.box(this->rotationAxis()));
}

template class Capsule<float>;
template class Capsule<double>;

}  // namespace cutwater
