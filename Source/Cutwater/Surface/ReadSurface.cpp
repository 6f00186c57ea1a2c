#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Readers.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Text/Gzip.hpp>

#include <cmath>

namespace cutwater {

namespace {

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kSurfaceFormats.size(); ++i) {
    if (kSurfaceFormats[i].format != static_cast<SurfaceFormat>(i)) return false;
  }
  return kSurfaceFormats.back().format == SurfaceFormat::Vtk;
}
static_assert(isInOrder(), "namesOf() finds a format by its number");

std::string listOf(std::string_view SurfaceFormatNames::*name, std::string_view conjunction) {
  std::string text;
  for (const auto& format : kSurfaceFormats) {
    const bool isLast = &format == &kSurfaceFormats.back();
    if (!text.empty()) text += isLast ? " " + std::string(conjunction) + " " : ", ";
    text += format.*name;
  }
  return text;
}

void requireOptions(const ReadOptions& options) {
  require(options.scale > 0 && std::isfinite(options.scale),
          "readSurface: need 0 < scale < infinity", Named{"scale", options.scale});
  require(isFinite(options.placement.offset()), "readSurface: need a finite placement",
          Named{"offset", options.placement.offset()});
}

// "hull" for "models/hull.stl.gz".
std::string stem(const std::string& name) {
  std::filesystem::path file = std::filesystem::path(name).filename();
  if (file.extension() == ".gz") file = file.stem();
  file = file.stem();
  return file.empty() ? "surface" : file.string();
}

SurfaceFile readContent(text::Content content, bool compressed, const ReadOptions& options) {
  if (content.bytes.empty()) throw Error(ErrorKind::File, content.name + ": the file is empty");
  ReadReport report;
  report.compressed = compressed;
  report.bytes = content.bytes.size();
  content.bytes = text::withoutByteOrderMark(content.bytes);
  const auto [format, reader] = formats::detectFormat(content);
  report.format = format;
  formats::SoupBuilder builder(options, stem(content.name));
  builder.report() = report;
  return reader(content, builder);
}

}  // namespace

std::string surfaceFormats(std::string_view conjunction) {
  return listOf(&SurfaceFormatNames::name, conjunction);
}

std::string surfaceExtensions(std::string_view conjunction) {
  return listOf(&SurfaceFormatNames::extension, conjunction);
}

SurfaceFile readSurface(const std::filesystem::path& path, const ReadOptions& options) {
  requireOptions(options);
  const std::string name = path.string();
  text::Bytes file = text::loadFile(path, options.maxBytes);
  const bool compressed = text::isGzip(file.view());
  if (compressed) file = text::gunzip(name, file.view(), options.maxBytes);
  return readContent({name, file.view()}, compressed, options);
}

SurfaceFile readSurface(std::span<const std::byte> bytes, const std::string& name,
                        const ReadOptions& options) {
  requireOptions(options);
  const std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  text::requireSize(name, view.size(), options.maxBytes);
  if (!text::isGzip(view)) return readContent({name, view}, false, options);
  const text::Bytes inflated = text::gunzip(name, view, options.maxBytes);
  return readContent({name, inflated.view()}, true, options);
}

}  // namespace cutwater
