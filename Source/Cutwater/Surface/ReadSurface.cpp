#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Readers.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Text/Gzip.hpp>

namespace cutwater {

namespace {

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kSurfaceFormats.size(); ++i) {
    if (kSurfaceFormats[i].format != static_cast<SurfaceFormat>(i)) return false;
  }
  return kSurfaceFormats.back().format == SurfaceFormat::Vtp;
}
static_assert(isInOrder(), "namesOf() finds a format by its number");

std::string listOf(std::span<const SurfaceFormatNames> formats,
                   std::string_view SurfaceFormatNames::*name, std::string_view conjunction) {
  std::string text;
  for (const auto& format : formats) {
    const bool isLast = &format == &formats.back();
    if (!text.empty()) text += isLast ? " " + std::string(conjunction) + " " : ", ";
    text += format.*name;
  }
  return text;
}

SurfaceFile readContent(text::Content content, bool compressed, const ReadOptions& options) {
  if (content.bytes.empty()) throw Error(ErrorKind::File, content.name + ": the file is empty");
  ReadReport report;
  report.compressed = compressed;
  report.bytes = content.bytes.size();
  content.bytes = text::withoutByteOrderMark(content.bytes);
  const auto [format, reader] = formats::detectFormat(content);
  report.format = format;
  formats::SoupBuilder builder(options, formats::patchNameOf(content.name));
  builder.report() = report;
  return reader(content, builder);
}

}  // namespace

std::string surfaceFormats(std::string_view conjunction) {
  return listOf(kReadSurfaceFormats, &SurfaceFormatNames::name, conjunction);
}

std::string anySurfaceFormats(std::string_view conjunction) {
  return listOf(kSurfaceFormats, &SurfaceFormatNames::name, conjunction);
}

std::string surfaceExtensions(std::string_view conjunction) {
  return listOf(kReadSurfaceFormats, &SurfaceFormatNames::extension, conjunction);
}

SurfaceFile readSurface(const std::filesystem::path& path, const ReadOptions& options) {
  formats::requireReadOptions(options);
  const std::string name = path.string();
  text::Bytes file = text::loadFile(path, options.maxBytes);
  const bool compressed = text::isGzip(file.view());
  if (compressed) file = text::gunzip(name, file.view(), options.maxBytes);
  return readContent({name, file.view()}, compressed, options);
}

SurfaceFile readSurface(std::span<const std::byte> bytes, const std::string& name,
                        const ReadOptions& options) {
  formats::requireReadOptions(options);
  const std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  text::requireSize(name, view.size(), options.maxBytes);
  if (!text::isGzip(view)) return readContent({name, view}, false, options);
  const text::Bytes inflated = text::gunzip(name, view, options.maxBytes);
  return readContent({name, inflated.view()}, true, options);
}

}  // namespace cutwater
