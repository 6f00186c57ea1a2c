#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>

namespace cutwater {

/// Copies of something at multiples of a period along each axis.
template <std::floating_point T>
struct Repeats {
  Vec3<T> period;  ///< 0: not repeated along this axis
  /// Copies along each axis, the original first; 0: endless in both directions.
  std::array<std::uint32_t, 3> count{};
};

}  // namespace cutwater
