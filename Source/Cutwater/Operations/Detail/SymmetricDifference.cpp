#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/SymmetricDifference.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>

namespace cutwater {

namespace {

bool isCertain(BoxClass c) {
  return c == BoxClass::Inside || c == BoxClass::Outside;
}

}  // namespace

template <std::floating_point T>
T SymmetricDifference<T>::combined(T a, T b) const {
  return std::max(std::min(a, b), -std::max(a, b));
}

template <std::floating_point T>
Interval<T> SymmetricDifference<T>::combined(const Interval<T>& a, const Interval<T>& b) const {
  return {std::max(std::min(a.lower, b.lower), -std::max(a.upper, b.upper)),
          std::max(std::min(a.upper, b.upper), -std::max(a.lower, b.lower))};
}

template <std::floating_point T>
auto SymmetricDifference<T>::nearest(const Vec3<T>& p) const -> Nearest {
  const T a = this->first().signedDistance(p);
  const T b = this->second().signedDistance(p);
  const bool isSecond = std::abs(b) < std::abs(a);
  return {isSecond ? std::size_t{1} : std::size_t{0}, combined(a, b), (isSecond ? a : b) < 0};
}

template <std::floating_point T>
Vec3<T> SymmetricDifference<T>::localGradient(const Vec3<T>& p) const {
  const auto at = nearest(p);
  const auto gradient = this->operand(at.operand).gradient(p);
  return at.turns ? -gradient : gradient;
}

template <std::floating_point T>
SurfacePoint<T> SymmetricDifference<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto at = nearest(p);
  auto found = this->operand(at.operand).closestPoint(p);
  const auto promise = localGuarantee();
  const T residual = this->localSignedDistance(found.point);
  if (!(std::abs(residual) <= promise.error(length(p) + length(found.point)))) {
    return SignedDistanceFunction<T>::localClosestPoint(p);
  }
  if (at.turns) found.normal = -found.normal;
  found.owner = this->counted(found.owner, at.operand);
  found.distance = at.value;
  detail::setTolerance(found, p, residual, promise);
  return found;
}

template <std::floating_point T>
BoxClass SymmetricDifference<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto a = this->classOf(this->first(), box);
  const auto b = this->classOf(this->second(), box);
  if (isCertain(a) && isCertain(b)) return a == b ? BoxClass::Outside : BoxClass::Inside;
  if ((a == BoxClass::Cut && isCertain(b)) || (b == BoxClass::Cut && isCertain(a))) {
    return BoxClass::Cut;
  }
  const auto range = this->localBounds(box, hint);
  if (range.lower > 0) return BoxClass::Outside;
  if (range.upper < 0) return BoxClass::Inside;
  const auto promise = localGuarantee();
  if (!box.isWithin(promise.domain)) return BoxClass::Unknown;
  // The nearest point of one surface lies on no other surface that is farther away.
  const T gap = std::abs(std::abs(this->first().signedDistance(box.center)) -
                         std::abs(this->second().signedDistance(box.center)));
  const bool isOfOne = gap > 4 * promise.error(length(box.center) + box.radius());
  const bool isCut = (isOfOne && this->holdsNearestPoint(box)) || this->holdsBothSides(box);
  return isCut ? BoxClass::Cut : this->classOfUndecided(box);
}

template <std::floating_point T>
Guarantee<T> SymmetricDifference<T>::localGuarantee() const {
  auto promise = detail::common(this->first().guarantee(), this->second().guarantee());
  // Each side has points inside and outside each operand.
  promise.inside = promise.outside = std::min(promise.inside, promise.outside);
  return promise;
}

template <std::floating_point T>
Box<T> SymmetricDifference<T>::localBoundingBox() const {
  return this->first().boundingBox().extend(this->second().boundingBox());
}

template class SymmetricDifference<float>;
template class SymmetricDifference<double>;

}  // namespace cutwater
