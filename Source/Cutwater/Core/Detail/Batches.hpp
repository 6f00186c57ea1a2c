#pragma once

#include <algorithm>
#include <cstddef>

namespace cutwater::detail {

/// Splits the indices 0 .. count - 1 into batches of `size`, of which the last may be smaller, and
/// calls visit(first, count) with the first index and the length of one after the other. For work
/// whose intermediate results are kept on the stack.
template <typename Visit>
void forBatches(std::size_t count, std::size_t size, Visit visit) {
  for (std::size_t first = 0; first < count; first += size) {
    visit(first, std::min(size, count - first));
  }
}

}  // namespace cutwater::detail
