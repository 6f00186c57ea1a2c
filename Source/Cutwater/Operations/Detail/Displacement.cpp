#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Displacement.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>

namespace cutwater {

template <std::floating_point T>
Displacement<T>::Displacement(Solid<T> operand, Solid<T> h, T amplitude)
    : BinaryOperation<T>(std::move(operand), std::move(h)), amplitude_(amplitude) {
  require(amplitude >= 0, "displaced: need an amplitude that is not negative",
          Named{"amplitude", amplitude});
}

template <std::floating_point T>
Interval<T> Displacement<T>::combined(const Interval<T>& a, const Interval<T>& b) const {
  const auto outward = [](T bound) {
    return std::isfinite(bound) ? 2 * std::numeric_limits<T>::epsilon() * std::abs(bound) : T(0);
  };
  // Infinite lower ends are all -inf, and upper ends inf.
  const Interval<T> sum{a.lower + b.lower, a.upper + b.upper};
  return {sum.lower - outward(sum.lower), sum.upper + outward(sum.upper)};
}

template <std::floating_point T>
Vec3<T> Displacement<T>::localGradient(const Vec3<T>& p) const {
  return this->first().gradient(p) + this->second().gradient(p);
}

template <std::floating_point T>
SurfaceOwner Displacement<T>::localOwner(const Vec3<T>& p) const {
  return this->first().closestPoint(p).owner;  // p is not on the operand's own surface
}

template <std::floating_point T>
Interval<T> Displacement<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const T most = amplitude_ + this->second().guarantee().error(length(box.center) + box.radius());
  const auto added = detail::intersection(this->boundsOf(this->second(), box), {-most, most});
  return combined(this->boundsOf(this->first(), box), added);
}

template <std::floating_point T>
Guarantee<T> Displacement<T>::localGuarantee() const {
  const auto a = this->first().guarantee();
  const auto b = this->second().guarantee();
  auto promise = detail::common(a, b);
  if (a.lipschitz && b.lipschitz) promise.lipschitz = *a.lipschitz + *b.lipschitz;
  promise.outside = promise.inside = detail::qualityBy(promise.lipschitz);
  promise.ulps = a.ulps + b.ulps + 1;
  return promise;
}

template <std::floating_point T>
Box<T> Displacement<T>::localBoundingBox() const {
  if (!std::isfinite(amplitude_)) return Box<T>::everywhere();
  return localGuarantee().grown(Offset<T>(this->first(), amplitude_).boundingBox());
}

template <std::floating_point T>
std::vector<std::string> Displacement<T>::localPatchNames() const {
  return this->first().patchNames();
}

template class Displacement<float>;
template class Displacement<double>;

}  // namespace cutwater
