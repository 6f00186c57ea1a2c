#pragma once

#include <cstddef>

namespace cutwater::tool {

/// How many bytes operator new has given out and not got back: exact, whatever the allocator keeps
/// for later and however small the work. Of the whole program; what libraries take by malloc() is
/// not counted.
class HeapUse {
 public:
  /// Counts from here.
  HeapUse();

  /// The most that was in use at a time since the start, beyond what was in use then.
  [[nodiscard]] std::size_t peak() const;

 private:
  std::size_t atStart_;
};

}  // namespace cutwater::tool
