#pragma once

#include <Cutwater/Tpms/CellSizes.hpp>

namespace cutwater::test {

/// The number of cells up to x, by the midpoint rule.
inline double cellsByQuadrature(const std::vector<CellSizeAt<double>>& sizes, double x) {
  const auto perLength = [&](double at) {
    if (at <= sizes.front().place) return 1 / sizes.front().size;
    for (std::size_t i = 1; i < sizes.size(); ++i) {
      const double t = (at - sizes[i - 1].place) / (sizes[i].place - sizes[i - 1].place);
      if (t <= 1) return (1 - t) / sizes[i - 1].size + t / sizes[i].size;
    }
    return 1 / sizes.back().size;
  };
  constexpr int kSteps = 20000;
  const double from = sizes.front().place;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += perLength(from + (x - from) * (i + 0.5) / kSteps);
  return sum * (x - from) / kSteps;
}

}  // namespace cutwater::test
