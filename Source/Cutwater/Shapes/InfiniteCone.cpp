#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>

#include <numbers>

namespace cutwater {

template <std::floating_point T>
InfiniteCone<T>::InfiniteCone(const Vec3<T>& apex, const Vec3<T>& axis, T halfAngle)
    : Axisymmetric<T>("InfiniteCone", apex, axis) {
  require(0 < halfAngle && halfAngle < 90, "InfiniteCone: need 0 < halfAngle < 90 degrees",
          Named{"halfAngle", halfAngle});
  const double radians = static_cast<double>(halfAngle) * (std::numbers::pi / 180);
  sine_ = static_cast<T>(std::sin(radians));
  cosine_ = static_cast<T>(std::cos(radians));
}

template <std::floating_point T>
bool InfiniteCone<T>::isBesideFlank(const ProfilePoint<T>& p) const {
  return p.axial * cosine_ + p.radial * sine_ > 0;
}

template <std::floating_point T>
T InfiniteCone<T>::profileDistance(const ProfilePoint<T>& p) const {
  return isBesideFlank(p) ? p.radial * cosine_ - p.axial * sine_ : length(p);
}

template <std::floating_point T>
ProfilePoint<T> InfiniteCone<T>::profileGradient(const ProfilePoint<T>& p) const {
  return isBesideFlank(p) ? ProfilePoint<T>{cosine_, -sine_} : normalized(p);
}

template <std::floating_point T>
Guarantee<T> InfiniteCone<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(this->origin()));
}

template <std::floating_point T>
Box<T> InfiniteCone<T>::localBoundingBox() const {
  // The apex bounds a coordinate if its axis is at 90 degrees or more to the whole cone.
  const T limit = -sine_ - 4 * std::numeric_limits<T>::epsilon();
  auto box = Box<T>::everywhere();
  for (int i = 0; i < 3; ++i) {
    if (this->axis()[i] <= limit) box.upper[i] = this->origin()[i];
    if (-this->axis()[i] <= limit) box.lower[i] = this->origin()[i];
  }
  return localGuarantee().grown(box);
}

template class InfiniteCone<float>;
template class InfiniteCone<double>;

}  // namespace cutwater
