#pragma once

#include <concepts>
#include <limits>
#include <numbers>

namespace cutwater::detail {

/// Radians in a period of a pattern, which is a cell of its map.
template <std::floating_point T>
inline constexpr T kTwoPi = 2 * std::numbers::pi_v<T>;
/// Factor that makes up for a few roundings of an upper bound.
template <std::floating_point T>
inline constexpr T kOutward = 1 + 16 * std::numeric_limits<T>::epsilon();

}  // namespace cutwater::detail
