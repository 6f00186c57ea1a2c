#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
ConeSphere<T>::ConeSphere(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Axisymmetric<T>(detail::RotationAxis<T>::between("ConeSphere", a, b)),
      profile_("ConeSphere", a, b, radiusA, radiusB),
      size_(detail::farther(a, b) + profile_.largestRadius()) {}

template <std::floating_point T>
T ConeSphere<T>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_.distance(p);
}

template <std::floating_point T>
ProfilePoint<T> ConeSphere<T>::profileGradient(const ProfilePoint<T>& p) const {
  return profile_.gradient(p);
}

template <std::floating_point T>
Guarantee<T> ConeSphere<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> ConeSphere<T>::localBoundingBox() const {
  return localGuarantee().grown(profile_.box(this->rotationAxis()));
}

template class ConeSphere<float>;
template class ConeSphere<double>;

}  // namespace cutwater
