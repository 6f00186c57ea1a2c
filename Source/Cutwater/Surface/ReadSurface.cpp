#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Readers.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Text/Gzip.hpp>

namespace cutwater {

namespace {

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
