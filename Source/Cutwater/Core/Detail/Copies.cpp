#include <Cutwater/Core/Detail/Copies.hpp>

#include <cmath>

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

template class Copies<float>;
template class Copies<double>;

}  // namespace cutwater::detail
