#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>

namespace cutwater {

template <std::floating_point T>
Offset<T>::Offset(Solid<T> operand, T distance)
    : UnaryOperation<T>(std::move(operand)), distance_(distance) {
  require(std::isfinite(distance), "offset: need a finite distance", Named{"distance", distance});
}

template <std::floating_point T>
T Offset<T>::localSignedDistance(const Vec3<T>& p) const {
  return this->operand().signedDistance(p) - distance_;
}

template <std::floating_point T>
void Offset<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                     std::span<T> distances) const {
  this->operandValues(points, distances);
  for (auto& distance : distances) distance -= distance_;
}

template <std::floating_point T>
SurfaceOwner Offset<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().closestPoint(p).owner;  // p is not on the operand's own surface
}

template <std::floating_point T>
Interval<T> Offset<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const auto range = this->boundsOf(this->operand(), box);
  const auto outward = [this](T bound) {
    return std::isfinite(bound)
               ? 2 * std::numeric_limits<T>::epsilon() * (std::abs(bound) + std::abs(distance_))
               : T(0);
  };
  return {range.lower - distance_ - outward(range.lower),
          range.upper - distance_ + outward(range.upper)};
}

template <std::floating_point T>
Guarantee<T> Offset<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  const Quality others = detail::qualityBy(promise.lipschitz);
  if (!(distance_ >= 0 && promise.outside == Quality::Exact)) promise.outside = others;
  if (!(distance_ <= 0 && promise.inside == Quality::Exact)) promise.inside = others;
  promise.ulps += 1;
  promise.size += std::abs(distance_);
  return promise;
}

template <std::floating_point T>
Box<T> Offset<T>::localBoundingBox() const {
  const auto promise = this->operand().guarantee();
  const auto box = this->operand().boundingBox();
  // {g < distance} stays within the distance of the solid only if g is no less than the distance
  // outside; it stays as deep below the surface only if g is no deeper than that inside.
  if (box.empty())
    return promise.outside == Quality::Exact || distance_ <= 0 ? box : box.everywhere();
  if (distance_ > 0 && promise.outside != Quality::Exact) return Box<T>::everywhere();
  if (distance_ < 0 && promise.inside == Quality::SignOnly) return box;
  const auto moved = localGuarantee().grown(box.grown(distance_));
  return moved.empty() ? Box<T>{} : moved;
}

template <std::floating_point T>
Box<T> Offset<T>::localClearanceBox() const {
  // Shrinking only adds to the values.
  const auto box = this->operand().clearanceBox();
  return distance_ >= 0 ? localGuarantee().grown(box.grown(distance_)) : box;
}

template class Offset<float>;
template class Offset<double>;

}  // namespace cutwater
