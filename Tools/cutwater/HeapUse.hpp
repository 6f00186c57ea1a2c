#pragma once

#include <cstddef>

namespace cutwater::tool {

/// Counts the bytes allocated by operator new and not yet freed. Exact, whatever the allocator
/// keeps for reuse and however small the work. Covers the whole program, except memory that
/// libraries take by malloc().
class HeapUse {
 public:
  /// Starts counting.
  HeapUse();

  /// The peak since the start, in excess of what was in use then.
  [[nodiscard]] std::size_t peak() const;

 private:
  std::size_t atStart_;
};

}  // namespace cutwater::tool
