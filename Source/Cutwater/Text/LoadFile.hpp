#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cutwater::text {

/// The bytes of a file, in memory.
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

}  // namespace cutwater::text
