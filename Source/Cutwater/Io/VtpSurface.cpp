#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/Surface/Formats/SoupBuilder.hpp>
#include <Cutwater/Text/Gzip.hpp>

namespace cutwater {

namespace {

constexpr std::uint8_t kPolygons = 7;
constexpr std::uint8_t kStrips = 6;

SurfaceFile surfaceOf(const text::Content& content, const PointData& data,
                      const ReadOptions& options) {
  const text::TextCursor at(content);
  if (data.mesh != DataMesh::PolyData)
    at.fail("a surface needs PolyData, not an unstructured grid");
  formats::SoupBuilder builder(options, formats::patchNameOf(content.name));
  builder.report().format = SurfaceFormat::Vtp;
  builder.report().bytes = content.bytes.size();
  builder.report().binary = data.isBinary;
  builder.reservePoints(data.points.size());
  for (const auto& p : data.points) builder.addPoint(p, at);
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < data.cells.count(); ++i) {
    const auto cell = data.cells.cell(i);
    if (data.cells.kinds[i] == kPolygons) {
      for (const auto corner : cell) builder.addCorner(static_cast<std::int64_t>(corner), at);
      builder.endPolygon(at);
    } else if (data.cells.kinds[i] == kStrips) {
      for (const auto corner : cell) builder.addStripCorner(static_cast<std::int64_t>(corner), at);
      builder.endStrip(at);
    } else {
      ++skipped;
    }
  }
  if (skipped > 0) builder.note(std::to_string(skipped) + " vertices and lines are not read.");
  return std::move(builder).finish(at);
}

}  // namespace

SurfaceFile readAnySurface(const std::filesystem::path& path, const ReadOptions& options) {
  formats::requireReadOptions(options);
  const std::string name = path.string();
  text::Bytes file = text::loadFile(path, options.maxBytes);
  const bool isCompressed = text::isGzip(file.view());
  if (isCompressed) file = text::gunzip(name, file.view(), options.maxBytes);
  const text::Content content{name, text::withoutByteOrderMark(file.view())};
  auto surface = detail::isXml(content.bytes)
                     ? surfaceOf(content, detail::readVtkXml(content, options.maxBytes), options)
                     : readSurface(std::as_bytes(std::span(file.view())), name, options);
  surface.report.compressed = isCompressed;
  return surface;
}

}  // namespace cutwater
