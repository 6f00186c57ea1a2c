#pragma once

#include <Cutwater/Core/Vec3.hpp>

/// Checked arguments of shapes that are given by points and directions. `shape` and `argument` go
/// into the message of the Error that a bad value throws.
namespace cutwater::detail {

template <std::floating_point T>
void requireFinite(const char* shape, const char* argument, const Vec3<T>& point);

/// @throws Error unless both are finite, none is negative, and one is positive.
template <std::floating_point T>
void requireRadii(const char* shape, T radiusA, T radiusB);

/// The unit vector along `direction`, rounded once whatever its length.
/// @throws Error unless the direction is finite and not zero.
template <std::floating_point T>
[[nodiscard]] Vec3<T> unitVector(const char* shape, const char* argument, const Vec3<T>& direction);

/// |b - a|, free of overflow on the way; infinite only if the result is.
template <std::floating_point T>
[[nodiscard]] T distanceBetween(const Vec3<T>& a, const Vec3<T>& b);

/// The larger of |a| and |b|, for the `size` of a Guarantee.
template <std::floating_point T>
[[nodiscard]] T farther(const Vec3<T>& a, const Vec3<T>& b);

}  // namespace cutwater::detail
