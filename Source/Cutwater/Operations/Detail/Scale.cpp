#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Scale.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

namespace cutwater {

template <std::floating_point T>
Scale<T>::Scale(Solid<T> operand, T factor)
    : UnaryOperation<T>(std::move(operand)), factor_(factor) {
  require(std::isfinite(factor) && std::isfinite(1 / factor),
          "scaled: need a finite factor that is not zero", Named{"factor", factor});
}

template <std::floating_point T>
T Scale<T>::localSignedDistance(const Vec3<T>& p) const {
  return std::abs(factor_) * this->operand().signedDistance(p / factor_);
}

template <std::floating_point T>
T Scale<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return this->operandValueWithin(p / factor_, std::abs(factor_), wanted);
}

template <std::floating_point T>
void Scale<T>::localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const {
  const auto shrink = [this](const Vec3<T>& p) { return p / factor_; };
  this->forImages(points, shrink, [&](std::span<const Vec3<T>> here, std::size_t first) {
    const auto values = distances.subspan(first, here.size());
    this->operandValues(here, values);
    for (auto& value : values) value *= std::abs(factor_);
  });
}

template <std::floating_point T>
Vec3<T> Scale<T>::mirrored(const Vec3<T>& direction) const {
  return factor_ < 0 ? -direction : direction;
}

template <std::floating_point T>
Vec3<T> Scale<T>::localGradient(const Vec3<T>& p) const {
  return mirrored(this->operand().gradient(p / factor_));
}

template <std::floating_point T>
SurfacePoint<T> Scale<T>::localClosestPoint(const Vec3<T>& p) const {
  return grown(this->operand().closestPoint(p / factor_), p);
}

template <std::floating_point T>
void Scale<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                  std::span<SurfacePoint<T>> results) const {
  const auto shrink = [this](const Vec3<T>& p) { return p / factor_; };
  this->forImages(points, shrink, [&](std::span<const Vec3<T>> here, std::size_t first) {
    const auto found = results.subspan(first, here.size());
    this->operandPoints(here, found);
    for (std::size_t i = 0; i < here.size(); ++i) found[i] = grown(found[i], points[first + i]);
  });
}

template <std::floating_point T>
SurfacePoint<T> Scale<T>::grown(SurfacePoint<T> found, const Vec3<T>& p) const {
  found.point *= factor_;
  found.normal = mirrored(found.normal);
  found.distance *= std::abs(factor_);
  found.tolerance *= std::abs(factor_);
  // Three more roundings: the query point, the point found and the value.
  found.tolerance += 4 * std::numeric_limits<T>::epsilon() * (length(p) + length(found.point));
  return found;
}

template <std::floating_point T>
SurfaceOwner Scale<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().owner(p / factor_);
}

template <std::floating_point T>
CrossingCount Scale<T>::localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const {
  const Segment<T> shrunkSegment{segment.start / factor_, segment.end / factor_};
  return this->operand().crossings(shrunkSegment, [&](Crossing<T> crossing) {
    crossing.point *= factor_;
    crossing.normal = mirrored(crossing.normal);
    return visit(crossing);
  });
}

template <std::floating_point T>
OrientedBox<T> Scale<T>::shrunk(const OrientedBox<T>& box) const {
  OrientedBox<T> result = box;
  result.center = box.center / factor_;
  for (auto& half : result.halfAxis) half = half / factor_;
  // The division rounds the centre, the half axes and the points that the box stands for.
  const T reach = length(box.center) + box.radius();
  result.slack = (box.slack + 4 * std::numeric_limits<T>::epsilon() * reach) / std::abs(factor_);
  return result;
}

template <std::floating_point T>
Interval<T> Scale<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto range = this->boundsOf(this->operand(), shrunk(box), hint);
  const T s = std::abs(factor_);
  const T outward = 2 * std::numeric_limits<T>::epsilon();
  return {s * range.lower - outward * std::abs(s * range.lower),
          s * range.upper + outward * std::abs(s * range.upper)};
}

template <std::floating_point T>
BoxClass Scale<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  return this->classOf(this->operand(), shrunk(box), hint);
}

template <std::floating_point T>
Guarantee<T> Scale<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  // The division moves the point by half an ulp, the product rounds the value once more.
  promise.ulps += promise.lipschitz.value_or(T(1)) + 1;
  promise.size *= std::abs(factor_);
  if (promise.domain != Box<T>::everywhere()) {
    const auto domain = promise.domain;
    promise.domain = {min(factor_ * domain.lower, factor_ * domain.upper),
                      max(factor_ * domain.lower, factor_ * domain.upper)};
  }
  return promise;
}

template <std::floating_point T>
Box<T> Scale<T>::image(const Box<T>& box) const {
  if (box.empty()) return box;
  const auto a = factor_ * box.lower;
  const auto b = factor_ * box.upper;
  return localGuarantee().grown({min(a, b), max(a, b)});
}

template <std::floating_point T>
Box<T> Scale<T>::localBoundingBox() const {
  return image(this->operand().boundingBox());
}

template <std::floating_point T>
Box<T> Scale<T>::localClearanceBox() const {
  return image(this->operand().clearanceBox());
}

template class Scale<float>;
template class Scale<double>;

}  // namespace cutwater
