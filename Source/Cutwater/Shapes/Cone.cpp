#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
Cone<T>::Cone(const Vec3<T>& apex, const Vec3<T>& base, T radius)
    : Axisymmetric<T>("Cone", apex, base - apex),
      profile_(apex, base, T(0), radius),
      size_(detail::farther(apex, base) + radius) {
  require(radius > 0 && std::isfinite(radius), "Cone: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
T Cone<T>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_.distance(p);
}

template <std::floating_point T>
ProfilePoint<T> Cone<T>::profileGradient(const ProfilePoint<T>& p) const {
  return profile_.gradient(p);
}

template <std::floating_point T>
Guarantee<T> Cone<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> Cone<T>::localBoundingBox() const {
  return localGuarantee().grown(profile_.box(this->rotationAxis()));
}

template class Cone<float>;
template class Cone<double>;

}  // namespace cutwater
