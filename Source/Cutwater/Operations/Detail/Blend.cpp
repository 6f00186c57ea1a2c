#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Blend.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>

namespace cutwater {

template <std::floating_point T>
Blend<T>::Blend(Solid<T> a, Solid<T> b, T t)
    : BinaryOperation<T>(std::move(a), std::move(b)), t_(t) {
  require(t >= 0 && t <= 1, "blended: need 0 <= t <= 1", Named{"t", t});
}

template <std::floating_point T>
T Blend<T>::combined(T a, T b) const {
  return (1 - t_) * a + t_ * b;
}

template <std::floating_point T>
Interval<T> Blend<T>::combined(const Interval<T>& a, const Interval<T>& b) const {
  if (!std::isfinite(a.lower + a.upper + b.lower + b.upper)) return Interval<T>::everything();
  const auto outward = [this](T x, T y) {
    return 4 * std::numeric_limits<T>::epsilon() * combined(std::abs(x), std::abs(y));
  };
  return {combined(a.lower, b.lower) - outward(a.lower, b.lower),
          combined(a.upper, b.upper) + outward(a.upper, b.upper)};
}

template <std::floating_point T>
Vec3<T> Blend<T>::localGradient(const Vec3<T>& p) const {
  return (1 - t_) * this->first().gradient(p) + t_ * this->second().gradient(p);
}

template <std::floating_point T>
Guarantee<T> Blend<T>::localGuarantee() const {
  const auto a = this->first().guarantee();
  const auto b = this->second().guarantee();
  auto promise = detail::common(a, b);
  if (a.lipschitz && b.lipschitz) promise.lipschitz = (1 - t_) * *a.lipschitz + t_ * *b.lipschitz;
  promise.outside = promise.inside = detail::qualityBy(promise.lipschitz);
  promise.ulps += 2;
  return promise;
}

template <std::floating_point T>
Box<T> Blend<T>::localBoundingBox() const {
  // Where both values are positive, so is the blend.
  return this->first().boundingBox().extend(this->second().boundingBox());
}

template class Blend<float>;
template class Blend<double>;

}  // namespace cutwater
