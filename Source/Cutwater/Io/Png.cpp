#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/OutputFile.hpp>
#include <Cutwater/Io/Png.hpp>

#ifdef CUTWATER_HAS_PNG
#include <png.h>
#endif

namespace cutwater {

#ifdef CUTWATER_HAS_PNG

namespace {

// libpng's simplified interface: it reports errors by its result and needs no setjmp of ours, which
// would skip destructors.
std::vector<std::byte> encoded(const std::filesystem::path& path, const Image& image) {
  static_assert(sizeof(Rgb) == 3);
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width());
  description.height = static_cast<png_uint_32>(image.height());
  description.format = PNG_FORMAT_RGB;
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(description));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&description, bytes.data(), &size, 0, image.pixels().data(), 0,
                                nullptr) == 0) {
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

#else

void writePng(const std::filesystem::path& path, const Image&) {
  throw Error(ErrorKind::File,
              path.string() + ": cannot write PNG: this library was built without libpng");
}

#endif

}  // namespace cutwater
