#pragma once

#include <ctime>

namespace cutwater::test {

/// Seconds of CPU time that `work` takes, all threads together: unlike the clock on the wall it
/// does not run while other processes have the cores. For limits that only a worse order of growth
/// can break.
template <typename Work>
double cpuSeconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace cutwater::test
