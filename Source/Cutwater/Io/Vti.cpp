#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/VtkXml.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <limits>

namespace cutwater {

namespace {

using detail::toText;

template <std::floating_point T>
std::string numbers(const Vec3<T>& v) {
  return toText(static_cast<double>(v.x)) + " " + toText(static_cast<double>(v.y)) + " " +
         toText(static_cast<double>(v.z));
}

/// VTK's extent counts points, also for cell data: n cells lie between n + 1 points.
std::string extentOf(const IndexBox& box, Centering centering) {
  const long long last = centering == Centering::Cell ? 1 : 0;
  std::string text;
  for (const auto& [lo, hi] : {std::pair(box.lo.i, box.hi.i), std::pair(box.lo.j, box.hi.j),
                               std::pair(box.lo.k, box.hi.k)}) {
    if (!text.empty()) text += ' ';
    text += toText(static_cast<long long>(lo)) + ' ' + toText(hi + last);
  }
  return text;
}

void checkArguments(const IndexBox& box, std::span<const VtkArray> arrays) {
  require(!box.empty(), "writeVti: need a grid patch that is not empty");
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  require(box.hi.i < kMost && box.hi.j < kMost && box.hi.k < kMost,
          "writeVti: need indices below 2^31 - 1");
  detail::checkVtkArrays("writeVti", arrays, box.count());
}

template <std::floating_point T>
std::string header(const GridPatch<T>& gridPatch, std::span<const VtkArray> arrays,
                   const VtiOptions& options) {
  const auto& level = gridPatch.level;
  const auto extent = extentOf(gridPatch.indices, level.centering());
  const bool cells = level.centering() == Centering::Cell;
  detail::VtkXml xml("ImageData", {{"WholeExtent", extent},
                                   {"Origin", numbers(level.origin())},
                                   {"Spacing", numbers(level.spacing())}});
  xml.patchNames(options.patchNames);
  xml.open("Piece", {{"Extent", extent}});
  xml.arrays(cells ? "CellData" : "PointData", arrays);
  xml.empty(cells ? "PointData" : "CellData");
  xml.close("Piece");
  return xml.finished();
}

}  // namespace

template <std::floating_point T>
void writeVti(const std::filesystem::path& path, const GridPatch<T>& gridPatch,
              std::span<const VtkArray> arrays, const VtiOptions& options) {
  checkArguments(gridPatch.indices, arrays);
  OutputFile file(path);
  file.write(header(gridPatch, arrays, options));
  detail::writeVtkArrays(file, arrays);
  file.write(detail::VtkXml::kEnd);
  file.commit();
}

template void writeVti(const std::filesystem::path&, const GridPatch<float>&,
                       std::span<const VtkArray>, const VtiOptions&);
template void writeVti(const std::filesystem::path&, const GridPatch<double>&,
                       std::span<const VtkArray>, const VtiOptions&);

}  // namespace cutwater
