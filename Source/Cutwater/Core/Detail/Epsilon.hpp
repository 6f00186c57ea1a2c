#pragma once
#include <concepts>
#include <limits>

namespace cutwater::detail {

/// Machine epsilon, the distance from 1 to the next number: twice the most that one rounding
/// changes a result by, relative to it.
template <std::floating_point T>
inline constexpr T kEps = std::numeric_limits<T>::epsilon();

}  // namespace cutwater::detail
