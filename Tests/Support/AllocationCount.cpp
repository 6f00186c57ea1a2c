#include "Support/AllocationCount.hpp"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

// The operators of the whole program. Sanitizers bring forms of their own of every operator; that
// these come first is why all of them are here.

namespace {

std::atomic<std::size_t> bytesInUse{0};
std::atomic<std::size_t> peak{0};
std::atomic<long long> allocations{0};
std::atomic<long long> frees{0};
std::atomic<long long> failing{0};  // of `allocations`

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = bytesInUse += malloc_usable_size(memory);
  std::size_t before = peak;
  while (before < now && !peak.compare_exchange_weak(before, now)) {
  }
  return memory;
}

void countOne() {
  if (++allocations != failing) return;
  ++frees;  // of nothing: it never lived
  throw std::bad_alloc();
}

void* allocate(std::size_t size) {
  countOne();
  return counted(std::malloc(size));
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  countOne();
  const auto multiple = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(multiple, (size + multiple - 1) / multiple * multiple));
}

template <typename... Alignment>
void* allocateOrNull(std::size_t size, Alignment... alignment) noexcept {
  try {
    return allocate(size, alignment...);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void release(void* memory) noexcept {
  if (memory == nullptr) return;
  bytesInUse -= malloc_usable_size(memory);
  ++frees;
  std::free(memory);
}

}  // namespace

namespace cutwater::test {

AllocationCount::AllocationCount()
    : bytesBefore_(bytesInUse), countBefore_(allocations), aliveBefore_(allocations - frees) {
  peak = bytesBefore_;
}

AllocationCount::~AllocationCount() {
  failAt(0);
}

std::size_t AllocationCount::peakBytes() const {
  return peak - bytesBefore_;
}

long long AllocationCount::count() const {
  return allocations - countBefore_;
}

long long AllocationCount::alive() const {
  return allocations - frees - aliveBefore_;
}

void AllocationCount::failAt(long long n) {
  failing = n > 0 ? allocations + n : 0;
}

}  // namespace cutwater::test

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t a) {
  return allocate(size, a);
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return allocate(size, a);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocateOrNull(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocateOrNull(size);
}
void* operator new(std::size_t size, std::align_val_t a, const std::nothrow_t&) noexcept {
  return allocateOrNull(size, a);
}
void* operator new[](std::size_t size, std::align_val_t a, const std::nothrow_t&) noexcept {
  return allocateOrNull(size, a);
}
void operator delete(void* p) noexcept {
  release(p);
}
void operator delete[](void* p) noexcept {
  release(p);
}
void operator delete(void* p, std::size_t) noexcept {
  release(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  release(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  release(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
  release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  release(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
  release(p);
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
  release(p);
}
void operator delete[](void* p, const std::nothrow_t&) noexcept {
  release(p);
}
