#pragma once

#include <Cutwater/Tpms/CellSizes.hpp>

#include <algorithm>

namespace cutwater::test {

/// The number of cells from the first place to x, by the midpoint rule from place to place: 1/size
/// is linear there, so that the rule is exact.
inline double cellsByQuadrature(const std::vector<CellSizeAt<double>>& sizes, double x) {
  double sum = std::min(x - sizes.front().place, 0.0) / sizes.front().size +
               std::max(x - sizes.back().place, 0.0) / sizes.back().size;
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    const auto& from = sizes[i - 1];
    const auto& to = sizes[i];
    const double length = std::clamp(x, from.place, to.place) - from.place;
    const double t = 0.5 * length / (to.place - from.place);
    sum += length * ((1 - t) / from.size + t / to.size);
  }
  return sum;
}

}  // namespace cutwater::test
