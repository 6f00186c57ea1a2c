#pragma once

#include <Cutwater/Core/Vec3.hpp>

/// Checks and measures points and radii given to shapes. `shape` and `argument` appear in the
/// message of the Error thrown for a bad value.
namespace cutwater::detail {

template <std::floating_point T>
void requireFinite(const char* shape, const char* argument, const Vec3<T>& point);

/// @throws Error unless both are finite, none is negative, and one is positive.
template <std::floating_point T>
void requireRadii(const char* shape, T radiusA, T radiusB);

/// |b - a|, without intermediate overflow; infinite only if the result is.
template <std::floating_point T>
[[nodiscard]] T distanceBetween(const Vec3<T>& a, const Vec3<T>& b);

/// The larger of |a| and |b|, for the `size` of a Guarantee.
template <std::floating_point T>
[[nodiscard]] T farther(const Vec3<T>& a, const Vec3<T>& b);

}  // namespace cutwater::detail
