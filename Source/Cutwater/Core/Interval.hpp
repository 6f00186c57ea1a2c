#pragma once

#include <Cutwater/Core/Detail/Inline.hpp>

#include <concepts>
#include <limits>

namespace cutwater {

/// A closed interval [lower, upper] of values.
template <std::floating_point T>
struct Interval {
  T lower{};
  T upper{};

  /// All numbers, including the infinities.
  static constexpr Interval everything() {
    return {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
  }

  /// Whether the value lies in the interval, both ends included.
  CUTWATER_INLINE constexpr bool contains(T value) const {
    return lower <= value && value <= upper;
  }
  /// The interval extended by `margin` at both ends.
  CUTWATER_INLINE constexpr Interval grown(T margin) const {
    return {lower - margin, upper + margin};
  }
  CUTWATER_INLINE friend constexpr Interval operator-(Interval a) { return {-a.upper, -a.lower}; }
  bool operator==(const Interval&) const = default;
};

}  // namespace cutwater
