#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace cutwater {

/// The place of an array in a Block: offset in bytes from the start, and number of elements.
struct Section {
  std::uint64_t offset = 0;
  std::uint64_t count = 0;
};

/// Read-only arrays of plain records in one shared piece of memory: on the heap, in a mapped file
/// or in a window shared by processes. Copies share the memory. It holds no pointers, so its bytes
/// can be written, sent and mapped unchanged.
class Block {
 public:
  Block() = default;
  Block(std::shared_ptr<const void> owner, std::span<const std::byte> bytes)
      : owner_(std::move(owner)), bytes_(bytes) {}

  /// The records of a section, in place.
  template <typename Record>
  [[nodiscard]] std::span<const Record> array(const Section& section) const {
    static_assert(std::is_trivially_copyable_v<Record>);
    return {reinterpret_cast<const Record*>(bytes_.data() + section.offset), section.count};
  }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  /// All bytes from `offset` on; shares the memory.
  [[nodiscard]] Block from(std::size_t offset) const { return {owner_, bytes_.subspan(offset)}; }
  /// The first `count` bytes; shares the memory.
  [[nodiscard]] Block first(std::size_t count) const { return {owner_, bytes_.first(count)}; }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const std::byte> bytes_;
};

/// Collects arrays and copies them into one block. Every array starts on a cache line.
class BlockWriter {
 public:
  /// Bytes in a cache line.
  static constexpr std::size_t kAlignment = 64;

  /// Registers an array. finish() copies its elements, which must live until then.
  template <typename Record>
  Section add(std::span<const Record> records) {
    static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) <= kAlignment);
    return addBytes(std::as_bytes(records), records.size());
  }
  template <typename Record>
  Section add(const std::vector<Record>& records) {
    return add(std::span<const Record>(records));
  }

  /// Returns one block of memory with all the arrays added.
  [[nodiscard]] Block finish() const;

 private:
  struct Piece {
    std::uint64_t offset;
    std::span<const std::byte> bytes;
  };

  Section addBytes(std::span<const std::byte> bytes, std::size_t count);

  std::vector<Piece> pieces_;
  std::uint64_t size_ = 0;
};

/// Copies the bytes to memory of their own. It begins at a multiple of BlockWriter::kAlignment and,
/// if large, consists of large pages where the system has them.
[[nodiscard]] Block alignedCopy(std::span<const std::byte> bytes);

}  // namespace cutwater
