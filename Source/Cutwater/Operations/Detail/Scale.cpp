#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Scale.hpp>

namespace cutwater {

template <std::floating_point T>
Scale<T>::Scale(Solid<T> operand, T factor)
    : Forwarding<T, Scale<T>>(std::move(operand)), factor_(factor) {
  require(std::isfinite(factor) && std::isfinite(1 / factor),
          "scaled: need a finite factor that is not zero", Named{"factor", factor});
}

template <std::floating_point T>
void Scale<T>::adjust(SurfacePoint<T>& found, const Vec3<T>& p) const {
  found.point *= factor_;
  turn(found.normal);
  found.distance *= std::abs(factor_);
  found.tolerance *= std::abs(factor_);
  // Three more roundings: the query point, the point found and the value.
  found.tolerance += 4 * std::numeric_limits<T>::epsilon() * (length(p) + length(found.point));
}

template <std::floating_point T>
void Scale<T>::adjust(Crossing<T>& found) const {
  found.point *= factor_;
  turn(found.normal);
}

template <std::floating_point T>
OrientedBox<T> Scale<T>::place(const OrientedBox<T>& box) const {
  OrientedBox<T> result = box;
  result.center = box.center / factor_;
  for (auto& half : result.halfAxis) half = half / factor_;
  // The division rounds the centre, the half axes and the points that the box stands for.
  const T reach = length(box.center) + box.radius();
  result.exact.reset();
  result.slack = (box.slack + 4 * std::numeric_limits<T>::epsilon() * reach) / std::abs(factor_);
  return result;
}

template <std::floating_point T>
Interval<T> Scale<T>::range(const Interval<T>& ofOperand) const {
  const T s = std::abs(factor_);
  const T outward = 2 * std::numeric_limits<T>::epsilon();
  return {s * ofOperand.lower - outward * std::abs(s * ofOperand.lower),
          s * ofOperand.upper + outward * std::abs(s * ofOperand.upper)};
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

template class Scale<float>;
template class Scale<double>;

}  // namespace cutwater
