#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cutwater {

namespace {

/// Memory for a block. For a large one, asks the system for large pages: a search accesses places
/// all over the tree, and with pages of 4 kB most of these accesses miss the processor's table of
/// addresses.
std::shared_ptr<void> allocate(std::size_t size) {
  constexpr std::size_t kLargePage = std::size_t{1} << 21U;
  const std::align_val_t align{size < kLargePage ? BlockWriter::kAlignment : kLargePage};
  std::shared_ptr<void> memory(::operator new(size, align),
                               [align](void* p) { ::operator delete(p, align); });
#ifdef __linux__
  // Only advice: if ignored, nothing changes. A remainder smaller than a page is left out.
  if (size >= kLargePage) madvise(memory.get(), size / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
  return memory;
}

}  // namespace

Section BlockWriter::addBytes(std::span<const std::byte> bytes, std::size_t count) {
  const Section section{size_, count};
  pieces_.push_back({size_, bytes});
  size_ += (bytes.size() + kAlignment - 1) / kAlignment * kAlignment;
  return section;
}

Block BlockWriter::finish() const {
  constexpr std::size_t kCopied = std::size_t{1} << 20U;  // by one thread at a time
  const auto memory = allocate(size_);
  auto* const start = static_cast<std::byte*>(memory.get());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto& piece = pieces_[i];
    auto* const to = start + piece.offset;
    parallelFor(piece.bytes.size(), {.grain = kCopied}, [&](std::size_t begin, std::size_t end) {
      std::ranges::copy(piece.bytes.subspan(begin, end - begin), to + begin);
    });
    const auto next = i + 1 < pieces_.size() ? pieces_[i + 1].offset : size_;
    // Fills the gaps too, so that equal blocks have equal bytes.
    std::fill(to + piece.bytes.size(), start + next, std::byte{0});
  }
  return {memory, {start, static_cast<std::size_t>(size_)}};
}

Block alignedCopy(std::span<const std::byte> bytes) {
  BlockWriter writer;
  writer.add(bytes);
  return writer.finish().first(bytes.size());
}

}  // namespace cutwater
