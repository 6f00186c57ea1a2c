#include <Cutwater/Mesh/Detail/GeometryHeader.hpp>
#include <Cutwater/Mesh/GeometryFile.hpp>

#include <cstdio>

namespace cutwater {

std::optional<GeometryFileInfo> geometryFileInfo(std::span<const std::byte> bytes) {
  if (!detail::isGeometry(bytes)) return {};
  const auto head = detail::geometryHead(bytes);
  return GeometryFileInfo{
      .version = head.version, .bytesPerNumber = head.bytesPerNumber, .source = head.source};
}

std::optional<GeometryFileInfo> geometryFileInfo(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // reading a pipe would empty it
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return {};
  std::array<std::byte, sizeof(detail::GeometryHead)> start;
  const auto count = std::fread(start.data(), 1, start.size(), file);
  static_cast<void>(std::fclose(file));
  return geometryFileInfo(std::span(start).first(count));
}

}  // namespace cutwater
