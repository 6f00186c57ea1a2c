#include <Cutwater/Core/Detail/Copies.hpp>

#include <cmath>
#include <limits>

namespace cutwater::detail {

template <std::floating_point T>
Vec3<T> Copies<T>::central(const Vec3<T>& p) const {
  Vec3<T> copy;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    if (!isRepeated(axis) || count == 1) continue;
    const T center = box_.empty() ? T(0) : box_.center()[axis];
    const T nearest = std::floor((p[axis] - center) / repeats_.period[axis] + T(0.5));
    copy[axis] = count == 0 ? nearest : std::clamp(nearest, T(0), static_cast<T>(count - 1));
  }
  return copy;
}

template <std::floating_point T>
bool Copies<T>::isAloneWithin(T limit, const Vec3<T>& p, const Vec3<T>& local) const {
  // More than the rounding of the search's distances, relative to what they are computed from; and
  // a distance whose square is no less than the smallest normal number.
  constexpr T kRounding = 16 * std::numeric_limits<T>::epsilon();
  constexpr T kLeast = T(sizeof(T) == sizeof(float) ? 0x1p-63 : 0x1p-511);
  const T apart = std::max(limit + kRounding * limit, kLeast);
  for (int axis = 0; axis < 3; ++axis) {
    if (!isRepeated(axis) || repeats_.count[static_cast<std::size_t>(axis)] == 1) continue;
    const T period = repeats_.period[axis];
    const T farSide = std::max(box_.upper[axis] - local[axis], local[axis] - box_.lower[axis]);
    const T size = std::abs(p[axis]) + std::abs(local[axis]) + farSide + period;
    if (!(period - farSide - kRounding * size > apart)) return false;
  }
  return true;
}

template <std::floating_point T>
Box<T> Copies<T>::boxOfAll() const {
  auto result = box_;
  if (result.empty()) return result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    if (!isRepeated(axis) || count == 1) continue;
    if (count == 0) {
      result.lower[axis] = -Box<T>::kInf;
      result.upper[axis] = Box<T>::kInf;
    } else {
      result.upper[axis] += static_cast<T>(count - 1) * repeats_.period[axis];
    }
  }
  return result;
}

template <std::floating_point T>
auto Copies<T>::ofBoxesWithin(T radius) const -> Reach {
  // A box beyond the first limit is that far away along the axis, where the central one is at most
  // half a period away unless it is the last. If it is, boxes are a period apart: see the second.
  Reach reach{{}, radius * radius};
  for (int axis = 0; axis < 3; ++axis) {
    const T period = repeats_.period[axis];
    if (isRepeated(axis)) {
      reach.along[axis] = std::max(radius + T(0.5) * period, radius / period * radius);
    }
  }
  return reach;
}

template <std::floating_point T>
double Copies<T>::mostWithin(T radius) const {
  double most = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    if (!isRepeated(axis) || count == 1) continue;
    const double size = double{box_.upper[axis]} - double{box_.lower[axis]} + 2 * double{radius};
    const double along = size / double{repeats_.period[axis]} + 1;
    most *= count == 0 ? along : std::min(along, static_cast<double>(count));
  }
  return most;
}

template class Copies<float>;
template class Copies<double>;

}  // namespace cutwater::detail
