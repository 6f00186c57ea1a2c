#include <Cutwater/Operations/GradedValue.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
GradedValue<T>::GradedValue(T value)
    : start_(value),
      least_(value),
      most_(value),
      known_{.lipschitz = T(0), .continuous = true, .ulps = 0, .size = std::abs(value)} {
  require(std::isfinite(value), "GradedValue: need a finite number", Named{"value", value});
}

template <std::floating_point T>
GradedValue<T>::GradedValue(const GradedValue&) = default;
template <std::floating_point T>
GradedValue<T>::GradedValue(GradedValue&&) noexcept = default;
template <std::floating_point T>
GradedValue<T>& GradedValue<T>::operator=(const GradedValue&) = default;
template <std::floating_point T>
GradedValue<T>& GradedValue<T>::operator=(GradedValue&&) noexcept = default;
template <std::floating_point T>
GradedValue<T>::~GradedValue() = default;

template <std::floating_point T>
void GradedValue<T>::setField(Solid<T> field) {
  constexpr T kUlps = 4;  // of the sum
  known_ = field.guarantee();
  require(known_.lipschitz && std::isfinite(*known_.lipschitz) && known_.continuous,
          "GradedValue: need a solid whose values have a Lipschitz constant");
  const T slope = std::abs(slope_);
  known_.outside = known_.inside = Quality::SignOnly;
  known_.lipschitz = slope * *known_.lipschitz;
  known_.ulps = slope * known_.ulps + kUlps;
  known_.size += std::max({std::abs(least_), std::abs(most_), std::abs(start_)});
  field_ = std::move(field);
}

template <std::floating_point T>
GradedValue<T> GradedValue<T>::byValueOf(Solid<T> solid, const GradedRamp<T>& ramp) {
  const T slope = (ramp.end - ramp.start) / ramp.over;
  require(ramp.over > 0 && std::isfinite(ramp.over) && std::isfinite(slope),
          "GradedValue: need finite numbers and 0 < over", Named{"start", ramp.start},
          Named{"end", ramp.end}, Named{"over", ramp.over});
  GradedValue result(ramp.start);
  result.slope_ = slope;
  result.least_ = std::min(ramp.start, ramp.end);
  result.most_ = std::max(ramp.start, ramp.end);
  result.setField(std::move(solid));
  return result;
}

template <std::floating_point T>
GradedValue<T> GradedValue<T>::byDistanceTo(Solid<T> solid, const GradedRamp<T>& ramp) {
  auto result = byValueOf(std::move(solid), ramp);
  result.isByDistance_ = true;
  return result;
}

template <std::floating_point T>
void GradedValue<T>::requireLimits(const GradedLimits<T>& limits) {
  require(limits.least <= limits.most && std::isfinite(limits.least) && std::isfinite(limits.most),
          "GradedValue: need finite limits, least <= most", Named{"least", limits.least},
          Named{"most", limits.most});
  detail::requireLimits("GradedValue", functionLimits(limits));
}

template <std::floating_point T>
GradedValue<T> GradedValue<T>::byField(Solid<T> field, const GradedLimits<T>& limits) {
  GradedValue result(T(0));
  result.slope_ = 1;
  result.least_ = limits.least;
  result.most_ = limits.most;
  result.setField(std::move(field));
  return result;
}

template <std::floating_point T>
T GradedValue<T>::unlimited(T value) const {
  return start_ + slope_ * (isByDistance_ ? std::abs(value) : value);
}

template <std::floating_point T>
T GradedValue<T>::at(const Vec3<T>& p) const {
  if (isConstant()) return start_;
  // In this order, NaN gives the least.
  return std::min(most_, std::max(least_, unlimited(field_->signedDistance(p))));
}

template <std::floating_point T>
Vec3<T> GradedValue<T>::gradient(const Vec3<T>& p) const {
  if (isConstant()) return {};
  const T value = field_->signedDistance(p);
  const T raw = unlimited(value);
  if (!(raw > least_ && raw < most_)) return {};
  const bool isInside = isByDistance_ && value < 0;
  return (isInside ? -slope_ : slope_) * field_->gradient(p);
}

template <std::floating_point T>
T GradedValue<T>::lipschitzWithin(const Vec3<T>& p, T radius) const {
  if (isConstant()) return 0;
  const T raw = unlimited(field_->signedDistance(p));
  const T change = lipschitz() * radius;
  return raw + change < least_ || raw - change > most_ ? T(0) : lipschitz();
}

template class GradedValue<float>;
template class GradedValue<double>;

}  // namespace cutwater
