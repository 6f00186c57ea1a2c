#pragma once

#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <numbers>

namespace cutwater::detail {

/// Radians in a turn, which is a period of a pattern and a cell of its map.
template <std::floating_point T>
inline constexpr T kTwoPi = 2 * std::numbers::pi_v<T>;
/// Factor that makes up for a few roundings of an upper bound.
template <std::floating_point T>
inline constexpr T kOutward = 1 + 16 * std::numeric_limits<T>::epsilon();

/// The gradient, by differences, of a value among cells of this size. Steps are smaller than the
/// default's, as values have kinks, and relative to cells, as sizes in guarantees are larger.
template <std::floating_point T, typename Value>
[[nodiscard]] Vec3<T> gradientAmongCells(const Value& value, const Vec3<T>& p, T cellSize) {
  constexpr T kStep = sizeof(T) == sizeof(float) ? T(4e-4) : T(2e-7);
  const T delta = kStep * (length(p) + cellSize);
  return centredDifferences<T>(value, p, delta) / (2 * delta);
}

}  // namespace cutwater::detail
