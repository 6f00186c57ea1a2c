#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>
#include <Cutwater/Operations/Detail/Shell.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Shell<T>::Shell(Solid<T> operand, T halfThickness)
    : UnaryOperation<T>(std::move(operand)), halfThickness_(halfThickness) {
  require(halfThickness > 0 && std::isfinite(halfThickness),
          "shell: need 0 < halfThickness < infinity", Named{"halfThickness", halfThickness});
}

template <std::floating_point T>
T Shell<T>::localSignedDistance(const Vec3<T>& p) const {
  return std::abs(this->operand().signedDistance(p)) - halfThickness_;
}

template <std::floating_point T>
void Shell<T>::localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const {
  this->operandValues(points, distances);
  for (auto& distance : distances) distance = std::abs(distance) - halfThickness_;
}

template <std::floating_point T>
Vec3<T> Shell<T>::localGradient(const Vec3<T>& p) const {
  const auto gradient = this->operand().gradient(p);
  return this->operand().signedDistance(p) < 0 ? -gradient : gradient;
}

template <std::floating_point T>
SurfaceOwner Shell<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().closestPoint(p).owner;  // p is not on the operand's own surface
}

template <std::floating_point T>
bool Shell<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  for (const T distance : {halfThickness_, -halfThickness_}) {
    const Solid<T> side = Offset<T>(this->operand(), distance);
    visit(side, &side);
  }
  return true;
}

template <std::floating_point T>
Interval<T> Shell<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const auto range = this->boundsOf(this->operand(), box);
  const T least = std::max({range.lower, -range.upper, T(0)});
  const T most = std::max(-range.lower, range.upper);
  const auto outward = [this](T bound) {
    return std::isfinite(bound) ? 2 * std::numeric_limits<T>::epsilon() * (bound + halfThickness_)
                                : T(0);
  };
  return {least - halfThickness_ - outward(least), most - halfThickness_ + outward(most)};
}

template <std::floating_point T>
Guarantee<T> Shell<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  const bool isExact = promise.outside == Quality::Exact && promise.inside == Quality::Exact;
  promise.inside = detail::qualityBy(promise.lipschitz);
  promise.outside = isExact ? Quality::Exact : promise.inside;
  promise.ulps += 1;
  promise.size += halfThickness_;
  return promise;
}

template <std::floating_point T>
Box<T> Shell<T>::localBoundingBox() const {
  return Offset<T>(this->operand(), halfThickness_).boundingBox();
}

template <std::floating_point T>
Box<T> Shell<T>::localClearanceBox() const {
  // |g| - t is at least g - t.
  return Offset<T>(this->operand(), halfThickness_).clearanceBox();
}

template class Shell<float>;
template class Shell<double>;

}  // namespace cutwater
