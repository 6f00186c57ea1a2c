#pragma once

#include <Cutwater/Core/Inline.hpp>

#include <concepts>
#include <limits>

namespace cutwater {

/// A closed interval [lower, upper] of values.
template <std::floating_point T>
struct Interval {
  T lower{};
  T upper{};

  /// All numbers, infinities among them.
  static constexpr Interval everything() {
    return {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
  }

  /// Both ends belong to it.
  CUTWATER_INLINE constexpr bool contains(T value) const {
    return lower <= value && value <= upper;
  }
  /// Longer by `margin` at both ends.
  CUTWATER_INLINE constexpr Interval grown(T margin) const {
    return {lower - margin, upper + margin};
  }
  CUTWATER_INLINE friend constexpr Interval operator-(Interval a) { return {-a.upper, -a.lower}; }
  bool operator==(const Interval&) const = default;
};

}  // namespace cutwater
