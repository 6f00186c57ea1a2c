#pragma once

#include <Cutwater/Core/FunctionRef.hpp>

#include <cstddef>
#include <functional>

namespace cutwater {

/// Called from time to time with the fraction done, from 0 to 1, only by the thread that started
/// the work.
using Progress = std::function<void(double fraction)>;

/// Options of all parallel work. No result depends on them.
struct ParallelOptions {
  /// The maximum number of threads; 0: as many as OpenMP would use. Always 1 inside an active
  /// parallel region and in a library built without OpenMP; never more than OpenMP would use or, if
  /// that is more, four for each processor.
  int threads = 0;
  /// Work is distributed in ranges of this many items.
  std::size_t grain = 1;
  Progress progress = {};
};

/// Calls body(begin, end) for ranges that together cover [0, count), in parallel.
///
/// The first exception thrown by `body` stops the distribution of work and is rethrown here,
/// outside the parallel region. OpenMP's global settings are not changed.
void parallelFor(std::size_t count, const ParallelOptions& options,
                 FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// The number of threads that parallelFor() would use if there is enough work.
[[nodiscard]] int availableThreads();

}  // namespace cutwater
