#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater {

/// The straight line from `start` (parameter 0) to `end` (parameter 1), both included.
template <std::floating_point T>
struct Segment {
  Vec3<T> start;
  Vec3<T> end;

  /// The point at this parameter.
  CUTWATER_INLINE constexpr Vec3<T> at(T parameter) const {
    return (T(1) - parameter) * start + parameter * end;  // exact at both ends
  }
};

}  // namespace cutwater
