#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Png.hpp>

#include <png.h>

namespace cutwater {

namespace {

/// Red, green, blue and opacity of each pixel.
std::vector<png_byte> withOpacities(const Image& image) {
  std::vector<png_byte> bytes;
  bytes.reserve(4 * image.pixels().size());
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const auto& c = image.pixels()[i];
    for (const auto byte : {c.red, c.green, c.blue, image.opacities()[i]}) bytes.push_back(byte);
  }
  return bytes;
}

// libpng's simplified interface: it reports errors by its result and needs no setjmp of ours, which
// would skip destructors.
std::vector<std::byte> encoded(const std::filesystem::path& path, const Image& image) {
  static_assert(sizeof(Rgb) == 3);
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width());
  description.height = static_cast<png_uint_32>(image.height());
  const bool opaque = image.opacities().empty();
  description.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const auto rgba = opaque ? std::vector<png_byte>{} : withOpacities(image);
  const void* const pixels = opaque ? static_cast<const void*>(image.pixels().data()) : rgba.data();
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(description));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&description, bytes.data(), &size, 0, pixels, 0, nullptr) == 0) {
    const std::string reason = description.message;
    png_image_free(&description);
    throw Error(ErrorKind::File, path.string() + ": cannot encode the picture: " + reason);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image) {
  const auto bytes = encoded(path, image);
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace cutwater
