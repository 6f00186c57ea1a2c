#pragma once

#include <string>
#include <vector>

namespace cutwater {

/// A value on an axis and its label.
struct Tick {
  double value;
  std::string label;
};

/// The smallest number of the form 1, 2 or 5 times a power of ten that is not below `wanted`.
/// Positive and finite for every positive, finite argument.
[[nodiscard]] double roundStep(double wanted);

/// The multiples of `step` in [lower, upper], labelled with only the digits they need.
/// @throws Error unless lower <= upper are finite, step > 0, and there are at most 10 000 of them.
[[nodiscard]] std::vector<Tick> ticksBetween(double lower, double upper, double step);

/// Formats a round length: "0.25 m"; without a unit only the number.
/// @throws Error unless it is finite and above 0.
[[nodiscard]] std::string lengthLabel(double length, const std::string& unit);

}  // namespace cutwater
