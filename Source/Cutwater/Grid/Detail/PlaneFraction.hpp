#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater::detail {

/// The fraction of the unit cube about the origin in which value + <gradient, x> < 0. Without a
/// gradient, 1 if the value is negative, else 0.
///
/// Scardovelli & Zaleski, "Analytical relations connecting linear interfaces and volume fractions
/// in rectangular grids", J. Comput. Phys. 164 (2000), section 3. Accurate to about 10^-5 where the
/// plane is nearly parallel to an axis.
[[nodiscard]] double planeFraction(double value, const Vec3<double>& gradient);

}  // namespace cutwater::detail
