#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cutwater::text {

/// Bytes gathered in chunks while their number is unknown, then joined: this takes at most twice
/// the final size, whereas doubling a vector would take three times.
class ChunkedBytes {
 public:
  /// A chunk to be filled from its beginning, and its size.
  struct Chunk {
    char* data;
    std::size_t size;
  };
  /// Room for more bytes.
  Chunk next();
  /// Sets how many bytes the last chunk holds.
  void filled(std::size_t bytes);
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Everything in one piece; the chunks are released.
  [[nodiscard]] std::unique_ptr<char[]> joined() &&;

 private:
  struct Part {
    std::unique_ptr<char[]> data;
    std::size_t used = 0;
  };
  std::vector<Part> parts_;
  std::uint64_t size_ = 0;
};

}  // namespace cutwater::text
