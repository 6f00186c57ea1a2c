#include <Cutwater/Operations/Detail/BinaryOperation.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
BinaryOperation<T>::BinaryOperation(Solid<T> first, Solid<T> second)
    : operands_{std::move(first), std::move(second)}, patches_(operands_) {}

template <std::floating_point T>
T BinaryOperation<T>::localSignedDistance(const Vec3<T>& p) const {
  return combined(first().signedDistance(p), second().signedDistance(p));
}

template <std::floating_point T>
void BinaryOperation<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                              std::span<T> distances) const {
  constexpr std::size_t kMost = 256;
  std::array<T, kMost> scratch;
  for (std::size_t begin = 0; begin < points.size(); begin += kMost) {
    const auto count = std::min(kMost, points.size() - begin);
    const auto here = points.subspan(begin, count);
    const auto values = distances.subspan(begin, count);
    const auto others = std::span<T>(scratch).first(count);
    first().signedDistances(here, values, {.threads = 1});
    second().signedDistances(here, others, {.threads = 1});
    for (std::size_t k = 0; k < count; ++k) values[k] = combined(values[k], others[k]);
  }
}

template <std::floating_point T>
SurfaceOwner BinaryOperation<T>::localOwner(const Vec3<T>& p) const {
  const T a = std::abs(first().signedDistance(p));
  const T b = std::abs(second().signedDistance(p));
  const std::size_t nearest = b < a ? 1 : 0;
  return counted(operand(nearest).owner(p), nearest);
}

template <std::floating_point T>
Interval<T> BinaryOperation<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  return combined(this->boundsOf(first(), box), this->boundsOf(second(), box));
}

template <std::floating_point T>
std::vector<std::string> BinaryOperation<T>::localPatchNames() const {
  return detail::OperandPatches<T>::names(operands_);
}

template class BinaryOperation<float>;
template class BinaryOperation<double>;

}  // namespace cutwater
