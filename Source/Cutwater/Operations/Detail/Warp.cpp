#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Warp.hpp>

namespace cutwater {

template <std::floating_point T>
Warp<T>::Warp(Solid<T> operand, detail::PointShift<T> shift, const FunctionLimits<T>& limits)
    : PointMap<T>(std::move(operand)), shift_(std::move(shift)), limits_(limits) {
  detail::requireLimits("warped", limits);
}

template <std::floating_point T>
OrientedBox<T> Warp<T>::mapped(const OrientedBox<T>& box) const {
  const T radius = box.radius();
  const Vec3<T> center = mapped(box.center);
  const T rounding = 4 * (limits_.ulps + 2) * std::numeric_limits<T>::epsilon() *
                     (length(box.center) + radius + length(center));
  const T reach = (1 + limits_.lipschitz) * radius + rounding;
  const auto byCenter = Box<T>{center, center}.grown(reach);
  const auto byAmplitude = box.bounds().grown(limits_.amplitude + rounding);
  return OrientedBox<T>::of(byCenter.intersection(byAmplitude));
}

template <std::floating_point T>
Vec3<T> Warp<T>::pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const {
  // v's derivatives, by centred differences.
  const T delta = std::cbrt(std::numeric_limits<T>::epsilon()) * (1 + length(p));
  Vec3<T> result = gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<T> step;
    step[axis] = delta;
    result[axis] += dot(shift_(p + step) - shift_(p - step), gradient) / (2 * delta);
  }
  return result;
}

template <std::floating_point T>
Guarantee<T> Warp<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  const T stretch = 1 + limits_.lipschitz;
  // |p + v(p)| <= stretch |p| + |v(0)|, and the rounding of v moves the point.
  promise.ulps = stretch * (promise.ulps + (limits_.ulps + 1) * promise.lipschitz.value_or(T(1)));
  promise.size += length(shift_({}));
  if (promise.lipschitz) promise.lipschitz = *promise.lipschitz * stretch;
  promise.outside = promise.inside = detail::qualityBy(promise.lipschitz);
  if (promise.domain != Box<T>::everywhere()) {
    promise.domain = std::isfinite(limits_.amplitude) && !promise.domain.empty()
                         ? promise.domain.grown(-limits_.amplitude)
                         : Box<T>{};
  }
  return promise;
}

template <std::floating_point T>
Box<T> Warp<T>::localBoundingBox() const {
  const auto box = this->operand().boundingBox();
  if (box.empty()) return box;
  if (!std::isfinite(limits_.amplitude)) return Box<T>::everywhere();
  return localGuarantee().grown(box.grown(limits_.amplitude));
}

template class Warp<float>;
template class Warp<double>;

}  // namespace cutwater
