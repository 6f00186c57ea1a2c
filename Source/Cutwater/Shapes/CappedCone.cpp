#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
CappedCone<T>::CappedCone(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Axisymmetric<T>("CappedCone", a, b - a),
      profile_(a, b, radiusA, radiusB),
      size_(detail::farther(a, b) + profile_.largestRadius()) {
  detail::requireRadii("CappedCone", radiusA, radiusB);
}

template <std::floating_point T>
T CappedCone<T>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_.distance(p);
}

template <std::floating_point T>
ProfilePoint<T> CappedCone<T>::profileGradient(const ProfilePoint<T>& p) const {
  return profile_.gradient(p);
}

template <std::floating_point T>
Guarantee<T> CappedCone<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> CappedCone<T>::localBoundingBox() const {
  return localGuarantee().grown(profile_.box(this->rotationAxis()));
}

template class CappedCone<float>;
template class CappedCone<double>;

}  // namespace cutwater
