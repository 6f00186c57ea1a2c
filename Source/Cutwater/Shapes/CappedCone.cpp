#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Direction.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
CappedCone<T>::CappedCone(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Axisymmetric<T>("CappedCone", a, b - a),
      profile_(detail::distanceBetween(a, b), radiusA, radiusB),
      size_(detail::farther(a, b) + std::max(radiusA, radiusB)) {
  require(radiusA >= 0 && radiusB >= 0 && radiusA + radiusB > 0 && std::isfinite(radiusA + radiusB),
          "CappedCone: need finite radii, none negative and one positive",
          Named{"radiusA", radiusA}, Named{"radiusB", radiusB});
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
  auto box = this->discBox(0, profile_.radiusA());
  return localGuarantee().grown(box.extend(this->discBox(profile_.height(), profile_.radiusB())));
}

template class CappedCone<float>;
template class CappedCone<double>;

}  // namespace cutwater
