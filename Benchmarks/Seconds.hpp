#pragma once

#include <chrono>

namespace cutwater::benchmarks {

/// Runs `work` and tells how many seconds it took.
template <typename Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace cutwater::benchmarks
