#pragma once

#include <Cutwater/Sdf/Detail/Defaults.hpp>

namespace cutwater::detail {

/// The gradient, by differences, of a value in a pattern with cells of this size. Steps are smaller
/// than the default's, as values have kinks, and relative to cells, as sizes in guarantees are
/// larger.
template <std::floating_point T, typename Value>
[[nodiscard]] Vec3<T> numericalGradient(const Value& value, const Vec3<T>& p, T cellSize) {
  constexpr T kStep = sizeof(T) == sizeof(float) ? T(4e-4) : T(2e-7);
  const T delta = kStep * (length(p) + cellSize);
  return centredDifferences<T>(value, p, delta) / (2 * delta);
}

}  // namespace cutwater::detail
