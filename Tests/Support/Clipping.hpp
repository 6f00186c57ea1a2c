#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace cutwater::test {

/// What of a convex polygon has a coordinate of at least (sign 1) or at most (-1) some value; exact
/// in rational numbers. (Sutherland and Hodgman 1974.)
template <typename Number>
std::vector<std::array<Number, 3>> clipped(const std::vector<std::array<Number, 3>>& polygon,
                                           std::size_t axis, const Number& value, int sign) {
  std::vector<std::array<Number, 3>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& here = polygon[i];
    const auto& next = polygon[(i + 1) % polygon.size()];
    const Number a = sign * (here[axis] - value);
    const Number b = sign * (next[axis] - value);
    if (a >= 0) kept.push_back(here);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
      auto& cut = kept.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) cut[k] = here[k] + a / (a - b) * (next[k] - here[k]);
      cut[axis] = value;
    }
  }
  return kept;
}

}  // namespace cutwater::test
