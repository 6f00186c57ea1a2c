#pragma once

#include <concepts>
#include <span>

namespace cutwater {

/// Sines and cosines of angles in turns, sin(2 pi t) and cos(2 pi t), with the same bits on every
/// processor, singly and in batches.
///
/// In turns, the reduction to an eighth of a turn is exact, however large the angle. Results are
/// off by less than 2 units in the last place; 0 and 1 at multiples of a quarter turn are exact.
/// Angles must be smaller than 2^51 turns, or 2^22 in single precision.
///
/// @throws Error if the spans differ in size.
template <std::floating_point T>
void sinesAndCosines(std::span<const T> turns, std::span<T> sines, std::span<T> cosines);

extern template void sinesAndCosines(std::span<const float>, std::span<float>, std::span<float>);
extern template void sinesAndCosines(std::span<const double>, std::span<double>, std::span<double>);

}  // namespace cutwater
