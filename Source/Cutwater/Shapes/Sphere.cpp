#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

namespace cutwater {

template <std::floating_point T>
Sphere<T>::Sphere(const Vec3<T>& center, T radius) : center_(center), radius_(radius) {
  require(isFinite(center), "Sphere: need a finite centre", Named{"center", center});
  require(radius > 0 && std::isfinite(radius), "Sphere: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
T Sphere<T>::localSignedDistance(const Vec3<T>& p) const {
  return length(p - center_) - radius_;
}

template <std::floating_point T>
Vec3<T> Sphere<T>::localGradient(const Vec3<T>& p) const {
  return normalized(p - center_);
}

template <std::floating_point T>
Interval<T> Sphere<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const auto distances = box.distancesFrom(center_);
  return detail::boundsWithin({distances.lower - radius_, distances.upper - radius_},
                              localSignedDistance(box.center), box, localGuarantee());
}

template <std::floating_point T>
Guarantee<T> Sphere<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(center_) + radius_);
}

template <std::floating_point T>
Box<T> Sphere<T>::localBoundingBox() const {
  return localGuarantee().grown(Box<T>{center_, center_}.grown(radius_));
}

template class Sphere<float>;
template class Sphere<double>;

}  // namespace cutwater
