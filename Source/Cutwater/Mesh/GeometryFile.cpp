#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/OutputFile.hpp>
#include <Cutwater/Mesh/Detail/GeometryHeader.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Text/MappedFile.hpp>

#include <algorithm>
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

// MeshSDF as bytes; the rest of the class is in MeshSDF.cpp.

template <std::floating_point T>
std::vector<std::byte> MeshSDF<T>::header(std::uint64_t source) const {
  const auto& patches = this->surface().patches;
  const std::uint64_t highest = patches.empty() ? 0 : *std::ranges::max_element(patches);
  return detail::geometryHeader<T>({.layout = layout_,
                                    .options = options_,
                                    .signs = this->signReport(),
                                    .placement = this->placement(),
                                    .patches = highest + 1,
                                    .source = source},
                                   block_.bytes());
}

template <std::floating_point T>
Block MeshSDF<T>::toBytes(std::uint64_t source) const {
  const auto header = this->header(source);
  BlockWriter writer;
  writer.add(header);
  writer.add(block_.bytes());
  return writer.finish();
}

template <std::floating_point T>
void MeshSDF<T>::save(const std::filesystem::path& path, std::uint64_t source) const {
  OutputFile file(path);
  file.write(header(source));
  file.write(block_.bytes());
  file.commit();
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::view(const Block& bytes, const MeshViewOptions& options) {
  const auto misaligned =
      reinterpret_cast<std::uintptr_t>(bytes.bytes().data()) % BlockWriter::kAlignment;
  require(misaligned == 0, "MeshSDF::view: need bytes that begin at a multiple of 64",
          Named{"beyond one by", misaligned});
  const auto [record, block] = detail::readGeometry<T>(bytes, options);
  MeshSDF result;
  result.options_ = record.options;
  result.takeBlock(block, record.layout);
  result.setSigns(record.signs, record.signs.scheme);
  result.setPlacement(record.placement);
  return result;
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::view(std::span<const std::byte> bytes, const MeshViewOptions& options) {
  return view(Block(nullptr, bytes), options);
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::open(const std::filesystem::path& path, const MeshViewOptions& options) {
  const auto bytes = text::mapFile(path);
  try {
    return view(bytes, options);
  } catch (const Error& error) {
    throw Error(error.kind(), path.string() + ": " + error.what());
  }
}

#define CUTWATER_DEFINE(T)                                                                  \
  template std::vector<std::byte> MeshSDF<T>::header(std::uint64_t) const;                  \
  template Block MeshSDF<T>::toBytes(std::uint64_t) const;                                  \
  template void MeshSDF<T>::save(const std::filesystem::path&, std::uint64_t) const;        \
  template MeshSDF<T> MeshSDF<T>::view(const Block&, const MeshViewOptions&);               \
  template MeshSDF<T> MeshSDF<T>::view(std::span<const std::byte>, const MeshViewOptions&); \
  template MeshSDF<T> MeshSDF<T>::open(const std::filesystem::path&, const MeshViewOptions&);
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE

}  // namespace cutwater
