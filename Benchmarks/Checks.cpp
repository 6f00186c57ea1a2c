#include "Checks.hpp"

#include <algorithm>
#include <cmath>

namespace cutwater::benchmarks {

void compare(const Comparison& comparison, Check& check) {
  const double limit = comparison.limit;
  for (std::size_t i = 0; i < comparison.points.size(); ++i) {
    const double truth = std::clamp(comparison.truth[i], -limit, limit);
    const double answer = comparison.answers[i];
    const double tolerance = comparison.tolerance(comparison.points[i]);
    const double error = std::abs(std::abs(answer) - std::abs(truth));
    ++check.answers;
    check.wrongValues += error <= tolerance ? 0U : 1U;
    // So close to the surface either sign is as good.
    const bool tellsSide = comparison.withSigns && std::abs(truth) > tolerance;
    check.wrongSigns += tellsSide && std::signbit(answer) != std::signbit(truth) ? 1U : 0U;
    check.largestError = std::max(check.largestError, error / comparison.diagonal);
  }
}

}  // namespace cutwater::benchmarks
