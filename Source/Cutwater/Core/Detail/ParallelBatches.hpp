#pragma once

#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Parallel.hpp>

namespace cutwater::detail {

/// forBatches() in parallel. Batches begin at multiples of `size` whatever the number of threads;
/// each thread takes one at a time, or as many as fit into `options.grain`.
template <typename Visit>
void parallelBatches(std::size_t count, std::size_t size, ParallelOptions options,
                     const Visit& visit) {
  options.grain = std::max(options.grain, size) / size * size;
  parallelFor(count, options, [&](std::size_t begin, std::size_t end) {
    forBatches(end - begin, size,
               [&](std::size_t first, std::size_t batch) { visit(begin + first, batch); });
  });
}

}  // namespace cutwater::detail
