#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Elongation.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Elongation<T>::Elongation(Solid<T> operand, const Vec3<T>& half)
    : PointMap<T>(std::move(operand)), half_(half) {
  require(isFinite(half) && half.x >= 0 && half.y >= 0 && half.z >= 0,
          "elongated: need finite lengths, none negative", Named{"half", half});
}

template <std::floating_point T>
Vec3<T> Elongation<T>::mapped(const Vec3<T>& p) const {
  return p - max(-half_, min(half_, p));
}

template <std::floating_point T>
OrientedBox<T> Elongation<T>::mapped(const OrientedBox<T>& box) const {
  // The map is monotone along each axis: the image of an axis-aligned box is such a box.
  const auto around = box.bounds();
  return OrientedBox<T>::of({mapped(around.lower), mapped(around.upper)});
}

template <std::floating_point T>
Vec3<T> Elongation<T>::pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const {
  Vec3<T> result = gradient;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(p[axis]) < half_[axis]) result[axis] = 0;
  }
  return result;
}

template <std::floating_point T>
Vec3<T> Elongation<T>::localGradient(const Vec3<T>& p) const {
  // In the gap, the operand is evaluated on its plane of symmetry, where it may have no gradient.
  // Values do not change across the gap, so this solid has one there. Differences may reach beyond
  // the gap, so their component across it is dropped, too.
  const auto ofOperand = this->operand().gradient(mapped(p));
  return pulledBack(
      p, ofOperand == Vec3<T>{} ? SignedDistanceFunction<T>::localGradient(p) : ofOperand);
}

template <std::floating_point T>
Guarantee<T> Elongation<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  promise.outside = std::min(promise.outside, Quality::LowerBound);
  promise.inside = std::min(promise.inside, Quality::LowerBound);
  promise.ulps += promise.lipschitz.value_or(T(1));  // of the difference
  // No point moves farther away, so the domain's box contains its own image if it contains 0.
  if (!promise.domain.contains({})) promise.domain = {};
  return promise;
}

template <std::floating_point T>
Box<T> Elongation<T>::localBoundingBox() const {
  const auto box = this->operand().boundingBox();
  if (box.empty()) return box;
  Box<T> result;
  for (int axis = 0; axis < 3; ++axis) {
    const T half = half_[axis];
    result.lower[axis] = box.lower[axis] + (box.lower[axis] > 0 ? half : -half);
    result.upper[axis] = box.upper[axis] + (box.upper[axis] < 0 ? -half : half);
  }
  auto promise = localGuarantee();
  promise.size += length(half_);
  return promise.grown(result);
}

template <std::floating_point T>
Box<T> Elongation<T>::localClearanceBox() const {
  // Along each axis, the image of a point beyond the box is at least as far beyond the operand's
  // box.
  const auto box = this->operand().clearanceBox();
  auto promise = localGuarantee();
  promise.size += length(half_);
  return promise.grown({box.lower - half_, box.upper + half_});
}

template class Elongation<float>;
template class Elongation<double>;

}  // namespace cutwater
