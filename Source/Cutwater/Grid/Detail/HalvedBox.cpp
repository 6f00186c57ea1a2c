#include <Cutwater/Grid/Detail/HalvedBox.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutwater::detail {

namespace {

constexpr int kMostHalvings = 30;  // indices are of 31 bits

}  // namespace

template <std::floating_point T>
bool HalvedBox<T>::divide() {
  const Vec3<double> whole = Vec3<double>(box_.upper) - Vec3<double>(box_.lower);
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size[axis] = std::ldexp(whole[static_cast<int>(axis)], -halvings_[axis]);
  }
  const double longest = std::ranges::max(size);
  std::array<bool, 3> isHalved{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    isHalved[axis] = size[axis] * std::numbers::sqrt2 > longest;
    if (isHalved[axis] && halvings_[axis] == kMostHalvings) return false;
  }
  isHalved_ = isHalved;
  halved_ = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    halvings_[axis] += isHalved[axis] ? 1 : 0;
    halved_ += isHalved[axis] ? 1 : 0;
  }
  return true;
}

template <std::floating_point T>
Index3 HalvedBox<T>::child(const Index3& parent, int number) const {
  const auto along = [&](std::size_t axis, std::int32_t index) {
    if (!isHalved_[axis]) return index;
    const auto child = 2 * index + (number & 1);
    number >>= 1;
    return child;
  };
  const auto i = along(0, parent.i);
  const auto j = along(1, parent.j);
  return {i, j, along(2, parent.k)};
}

template <std::floating_point T>
T HalvedBox<T>::face(int axis, std::int32_t index) const {
  const T lower = box_.lower[axis];
  const T upper = box_.upper[axis];
  const double part = std::ldexp(index, -halvings_[static_cast<std::size_t>(axis)]);
  if (part == 1) return upper;
  // Depends on the fraction of the box alone, not on the generation, and never decreases with it.
  return std::min(static_cast<T>(lower + part * (double{upper} - double{lower})), upper);
}

template <std::floating_point T>
Box<T> HalvedBox<T>::cell(const Index3& index) const {
  const auto& [i, j, k] = index;
  return {{face(0, i), face(1, j), face(2, k)}, {face(0, i + 1), face(1, j + 1), face(2, k + 1)}};
}

template class HalvedBox<float>;
template class HalvedBox<double>;

}  // namespace cutwater::detail
