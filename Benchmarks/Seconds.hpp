#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace cutwater::benchmarks {

/// Runs `work` and tells how many seconds it took.
template <typename Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of the best of three rounds.
template <typename Work>
double bestSecondsOf(const Work& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 3; ++round) best = std::min(best, secondsOf(work));
  return best;
}

}  // namespace cutwater::benchmarks
