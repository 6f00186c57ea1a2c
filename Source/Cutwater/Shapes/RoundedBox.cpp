#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/BoxDistance.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>

namespace cutwater {

template <std::floating_point T>
RoundedBox<T>::RoundedBox(const Box<T>& box, T radius)
    : core_(box.grown(-radius)), radius_(radius) {
  const auto size = box.size();
  require(isFinite(box) && size.x > 0 && size.y > 0 && size.z > 0,
          "RoundedBox: need finite corners with lower < upper", Named{"lower", box.lower},
          Named{"upper", box.upper});
  const T shortest = -maxComponent(-size);
  require(radius > 0 && radius <= T(0.5) * shortest,
          "RoundedBox: need 0 < radius <= half the shortest side", Named{"radius", radius},
          Named{"shortest side", shortest});
  for (int axis = 0; axis < 3; ++axis) {
    if (core_.lower[axis] > core_.upper[axis]) {  // by rounding: then the sides are half circles
      core_.lower[axis] = core_.upper[axis] = box.center()[axis];
    }
  }
}

template <std::floating_point T>
T RoundedBox<T>::localSignedDistance(const Vec3<T>& p) const {
  return detail::boxDistance(core_, p) - radius_;
}

template <std::floating_point T>
Vec3<T> RoundedBox<T>::localGradient(const Vec3<T>& p) const {
  return detail::boxGradient(core_, p);
}

template <std::floating_point T>
Interval<T> RoundedBox<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const auto toCore = detail::boxDistances(core_, box.bounds());
  return detail::boundsWithin({toCore.lower - radius_, toCore.upper - radius_},
                              localSignedDistance(box.center), box, localGuarantee());
}

template <std::floating_point T>
Guarantee<T> RoundedBox<T>::localGuarantee() const {
  return Guarantee<T>::exact(detail::farther(core_.lower, core_.upper) + radius_);
}

template <std::floating_point T>
Box<T> RoundedBox<T>::localBoundingBox() const {
  return localGuarantee().grown(core_.grown(radius_));
}

template class RoundedBox<float>;
template class RoundedBox<double>;

}  // namespace cutwater
