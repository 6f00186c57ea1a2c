#pragma once

#include <Cutwater/Sdf/Guarantee.hpp>

#include <span>

namespace cutwater::detail {

/// Computes the values at many points by valueWithin(point, limit), which returns the value, sooner
/// if it is not above the limit. Consecutive points are often close together, and as the Lipschitz
/// constant is 1, no value changes by more than the distance from one to the next.
template <std::floating_point T, typename ValueWithin>
void valuesInTurn(std::span<const Vec3<T>> points, std::span<T> values,
                  const Guarantee<T>& guarantee, const ValueWithin& valueWithin) {
  T limit = Box<T>::kInf;
  for (std::size_t i = 0; i < points.size(); ++i) {
    values[i] = valueWithin(points[i], limit);
    if (i + 1 == points.size()) break;
    limit = values[i] + length(points[i + 1] - points[i]);
    limit += 4 * guarantee.error(length(points[i]) + length(points[i + 1]));
  }
}

}  // namespace cutwater::detail
