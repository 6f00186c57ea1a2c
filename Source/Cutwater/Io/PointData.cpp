#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/Gzip.hpp>
#include <Cutwater/Text/TextCursor.hpp>
#include <Cutwater/Text/Words.hpp>

#include <array>
#include <limits>

namespace cutwater {

namespace {

using PointReader = PointData (*)(const text::Content&, std::uint64_t maxBytes);

PointReader readerOf(const text::Content& content) {
  constexpr std::string_view kVtk = "# vtk DataFile";
  constexpr std::string_view kNpy = "\x93NUMPY";
  const auto bytes = content.bytes;
  const auto isPartOf = [bytes](std::string_view word) {
    return bytes.size() < word.size() && word.starts_with(bytes);
  };
  if (isPartOf(kVtk) || isPartOf(kNpy)) {
    text::TextCursor(content).failAt({text::Place::Unit::Byte, 0},
                                     "the file is too short: it ends within its first word");
  }
  if (bytes.starts_with(kNpy)) return detail::readNpy;
  if (text::equalIgnoringCase(bytes.substr(0, kVtk.size()), kVtk)) return detail::readLegacyVtk;
  if (detail::isXml(bytes)) return detail::readVtkXml;
  return detail::readPointTable;
}

struct PointFormat {
  std::string_view extension;
  void (*requireFits)(const PointData&, const std::string& name);
  void (*write)(text::Output&, const PointData&);
};

constexpr std::array<PointFormat, 5> kPointFormats = {{
    {".csv", detail::requireFitsTable, detail::writePointTable},
    {".npy", detail::requireFitsNpy, detail::writeNpy},
    {".vtk", detail::requireFitsLegacyVtk, detail::writeLegacyVtk},
    {".vtu", detail::requireFitsUnstructuredXml, detail::writeUnstructuredXml},
    {".vtp", detail::requireFitsPolyDataXml, detail::writePolyDataXml},
}};

const PointFormat& pointFormatOf(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const auto& format : kPointFormats) {
    if (text::equalIgnoringCase(extension, format.extension)) return format;
  }
  throw Error(ErrorKind::Argument, path.string() + ": unknown extension \"" + extension +
                                       "\": points are written as .csv, .npy, .vtk, .vtu or .vtp");
}

}  // namespace

PointData readPointData(const std::filesystem::path& path, const ReadPointDataOptions& options) {
  const text::Bytes file = text::loadFile(path, options.maxBytes);
  return readPointData(std::as_bytes(std::span(file.view())), path.string(), options);
}

PointData readPointData(std::span<const std::byte> bytes, const std::string& name,
                        const ReadPointDataOptions& options) {
  std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  text::requireSize(name, view.size(), options.maxBytes);
  text::Bytes inflated;
  if (text::isGzip(view)) {
    inflated = text::gunzip(name, view, options.maxBytes);
    view = inflated.view();
  }
  if (view.empty()) throw Error(ErrorKind::File, name + ": the file is empty");
  const text::Content content{name, text::withoutByteOrderMark(view)};
  return readerOf(content)(content, options.maxBytes);
}

void requireWritable(const std::filesystem::path& path, const PointData& data) {
  pointFormatOf(path).requireFits(data, path.string());
}

void writePointData(const std::filesystem::path& path, const PointData& data) {
  const auto& format = pointFormatOf(path);
  format.requireFits(data, path.string());
  detail::checkPointData(data);
  OutputFile file(path);
  text::Output out(file);
  format.write(out, data);
  out.flush();
  file.commit();
}

std::vector<Vec3<double>> cellCenters(const PointData& data) {
  std::vector<Vec3<double>> centers(data.cells.count());
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const auto corners = data.cells.cell(i);
    // Each is divided first: sums may overflow.
    const double weight = 1 / static_cast<double>(corners.size());
    if (corners.empty())
      centers[i] += Vec3<double>{1, 1, 1} * std::numeric_limits<double>::quiet_NaN();
    for (const auto corner : corners) centers[i] += weight * data.points[corner];
  }
  return centers;
}

}  // namespace cutwater
