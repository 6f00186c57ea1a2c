#pragma once

#include <cstddef>

namespace cutwater::test {

/// What a program that has AllocationCount.cpp in it allocates by operator new, from the moment
/// this is made. One at a time.
class AllocationCount {
 public:
  AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;
  ~AllocationCount();

  /// The most bytes that were in use at once, beyond those in use at first.
  [[nodiscard]] std::size_t peakBytes() const;
  /// Allocations so far, of all threads, those freed again and that which failed included.
  [[nodiscard]] long long count() const;
  /// Those that are not freed yet, less those of before that are.
  [[nodiscard]] long long alive() const;

  /// Lets the n-th allocation from now on throw std::bad_alloc, in whatever thread it happens; the
  /// ones behind it succeed again. 0: none.
  void failAt(long long n);

 private:
  std::size_t bytesBefore_;
  long long countBefore_;
  long long aliveBefore_;
};

}  // namespace cutwater::test
