#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>

namespace cutwater {

template <std::floating_point T>
InfiniteCylinder<T>::InfiniteCylinder(const Vec3<T>& point, const Vec3<T>& axis, T radius)
    : Axisymmetric<T>("InfiniteCylinder", point, axis), radius_(radius) {
  require(radius > 0 && std::isfinite(radius), "InfiniteCylinder: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
T InfiniteCylinder<T>::profileDistance(const ProfilePoint<T>& p) const {
  return p.radial - radius_;
}

template <std::floating_point T>
ProfilePoint<T> InfiniteCylinder<T>::profileGradient(const ProfilePoint<T>&) const {
  return {1, 0};
}

template <std::floating_point T>
Guarantee<T> InfiniteCylinder<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(this->origin()) + radius_);
}

template <std::floating_point T>
Box<T> InfiniteCylinder<T>::localBoundingBox() const {
  auto box = this->rotationAxis().ballBox(0, radius_);
  for (int i = 0; i < 3; ++i) {
    if (this->axis()[i] != 0) box.lower[i] = -Box<T>::kInf, box.upper[i] = Box<T>::kInf;
  }
  return localGuarantee().grown(box);
}

template class InfiniteCylinder<float>;
template class InfiniteCylinder<double>;

}  // namespace cutwater
