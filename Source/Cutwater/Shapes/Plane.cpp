#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Plane.hpp>

namespace cutwater {

template <std::floating_point T>
Plane<T>::Plane(const Vec3<T>& point, const Vec3<T>& normal)
    : point_(point), normal_(detail::unitVector("Plane", "normal", normal)) {
  detail::requireFinite("Plane", "point", point);
}

template <std::floating_point T>
T Plane<T>::localSignedDistance(const Vec3<T>& p) const {
  return dot(p - point_, normal_);
}

template <std::floating_point T>
Vec3<T> Plane<T>::localGradient(const Vec3<T>&) const {
  return normal_;
}

template <std::floating_point T>
Interval<T> Plane<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const T atCenter = localSignedDistance(box.center);
  T reach = 2 * box.slack;
  for (const auto& half : box.halfAxis) reach += std::abs(dot(half, normal_));
  return detail::boundsWithin({atCenter - reach, atCenter + reach}, atCenter, box,
                              localGuarantee());
}

template <std::floating_point T>
BoxClass Plane<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  for (int axis = 0; axis < 3 && box.exact; ++axis) {
    if (!isAlong(normal_, axis)) continue;
    // Comparisons do not round. A box that only touches the plane holds points of it.
    const bool isUp = normal_[axis] > 0;
    const bool isAbove = box.exact->lower[axis] > point_[axis];
    const bool isBelow = box.exact->upper[axis] < point_[axis];
    if (isAbove || isBelow) return isAbove == isUp ? BoxClass::Outside : BoxClass::Inside;
    return BoxClass::Cut;
  }
  return SignedDistanceFunction<T>::localClassify(box, hint);
}

template <std::floating_point T>
Guarantee<T> Plane<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(point_));
}

template <std::floating_point T>
Box<T> Plane<T>::localBoundingBox() const {
  auto box = Box<T>::everywhere();
  for (int axis = 0; axis < 3; ++axis) {
    if (!isAlong(normal_, axis)) continue;
    (normal_[axis] > 0 ? box.upper : box.lower)[axis] = point_[axis];
  }
  return localGuarantee().grown(box);
}

template class Plane<float>;
template class Plane<double>;

}  // namespace cutwater
