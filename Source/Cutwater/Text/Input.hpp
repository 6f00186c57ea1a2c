#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cutwater::formats {

/// Bytes gathered in chunks while their number is unknown, then joined: this takes at most twice
/// the final size, whereas doubling a vector would take three times.
class Gathering {
 public:
  /// A chunk to be filled from its beginning, and its size.
  struct Chunk {
    char* data;
    std::size_t size;
  };
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

struct Bytes {
  std::unique_ptr<char[]> data;
  std::uint64_t size = 0;

  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// @throws Error(Limit) if the size is beyond `maxBytes`.
void requireSize(const std::string& name, std::uint64_t size, std::uint64_t maxBytes);

/// The whole file, also from a pipe.
/// @throws Error(File) if it cannot be read, Error(Limit) beyond `maxBytes`.
[[nodiscard]] Bytes loadFile(const std::filesystem::path& path, std::uint64_t maxBytes);

[[nodiscard]] bool isGzip(std::string_view bytes);

/// Inflates a gzip file: all of its members, one after another.
/// @throws Error(File) if the stream is truncated or corrupt, or if the library was built without
/// zlib; Error(Limit) beyond `maxBytes`.
[[nodiscard]] Bytes gunzip(const std::string& name, std::string_view compressed,
                           std::uint64_t maxBytes);

}  // namespace cutwater::formats
