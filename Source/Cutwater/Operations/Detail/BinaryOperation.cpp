#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Operations/Detail/BinaryOperation.hpp>

namespace cutwater {

template <std::floating_point T>
T BinaryOperation<T>::localSignedDistance(const Vec3<T>& p) const {
  return combined(first().signedDistance(p), second().signedDistance(p));
}

template <std::floating_point T>
void BinaryOperation<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                              std::span<T> distances) const {
  constexpr std::size_t kMost = 256;
  Scratch<T, kMost> scratch;
  detail::forBatches(points.size(), kMost, [&](std::size_t start, std::size_t count) {
    const auto here = points.subspan(start, count);
    const auto values = distances.subspan(start, count);
    const auto others = scratch.first(count);
    first().signedDistances(here, values, {.threads = 1});
    second().signedDistances(here, others, {.threads = 1});
    for (std::size_t k = 0; k < count; ++k) values[k] = combined(values[k], others[k]);
  });
}

template <std::floating_point T>
SurfaceOwner BinaryOperation<T>::localOwner(const Vec3<T>& p) const {
  const T a = std::abs(first().signedDistance(p));
  const T b = std::abs(second().signedDistance(p));
  const std::size_t nearest = b < a ? 1 : 0;
  return this->counted(this->operand(nearest).owner(p), nearest);
}

template <std::floating_point T>
Interval<T> BinaryOperation<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  return combined(this->boundsOf(first(), box), this->boundsOf(second(), box));
}

template class BinaryOperation<float>;
template class BinaryOperation<double>;

}  // namespace cutwater
