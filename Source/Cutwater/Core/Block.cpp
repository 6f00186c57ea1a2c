#include <Cutwater/Core/Block.hpp>

#include <algorithm>
#include <new>

namespace cutwater {

Section BlockWriter::addBytes(std::span<const std::byte> bytes, std::size_t count) {
  const Section section{size_, count};
  pieces_.push_back({size_, bytes});
  size_ += (bytes.size() + kAlignment - 1) / kAlignment * kAlignment;
  return section;
}

Block BlockWriter::finish() const {
  constexpr auto kAlign = std::align_val_t{kAlignment};
  const std::shared_ptr<void> memory(::operator new(size_, kAlign),
                                     [](void* p) { ::operator delete(p, kAlign); });
  auto* const start = static_cast<std::byte*>(memory.get());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto& piece = pieces_[i];
    auto* const end = std::ranges::copy(piece.bytes, start + piece.offset).out;
    const auto next = i + 1 < pieces_.size() ? pieces_[i + 1].offset : size_;
    std::fill(end, start + next, std::byte{0});  // the gaps too: equal blocks are equal bytes
  }
  return {memory, {start, static_cast<std::size_t>(size_)}};
}

}  // namespace cutwater
