#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater::detail {

/// The unit vector along `direction`, rounded once, whatever the length of `direction`. `caller`
/// and `argument` appear in the message of the error.
/// @throws Error unless the direction is finite and not zero.
template <std::floating_point T>
[[nodiscard]] Vec3<T> unitVector(const char* caller, const char* argument,
                                 const Vec3<T>& direction);

}  // namespace cutwater::detail
