#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeNodes.hpp>
#include <Cutwater/Io/Detail/VtkXml.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <algorithm>
#include <limits>

namespace cutwater {

namespace {

/// Records generated together before they are written, and those that a thread generates at a time.
constexpr std::size_t kStretch = std::size_t{1} << 17U;
constexpr std::size_t kGrain = std::size_t{1} << 12U;

constexpr std::uint8_t kVoxel = 11;
constexpr std::size_t kCorners = 8;

/// Writes one mesh, with node numbers of type Index.
template <std::floating_point T, typename Index>
class VtuWriter {
 public:
  VtuWriter(const OctreeCells<T>& mesh, const OctreeNodes<T>& nodes, const VtuOptions& options)
      : mesh_(mesh), nodes_(nodes), options_(options) {}

  void write(OutputFile& file, std::span<const VtkArray> arrays) const {
    file.write(header(arrays));
    writeRecords<Vec3<T>>(file, nodes_.count(), [&](std::size_t first, auto positions) {
      for (auto& position : positions) position = nodes_.position(first++);
    });
    writeRecords<Connectivity>(file, cellCount(),
                               [&](std::size_t first, auto cells) { writeCorners(first, cells); });
    writeRecords<Index>(file, cellCount(), [](std::size_t first, auto ends) {
      for (auto& end : ends) end = static_cast<Index>(kCorners * ++first);
    });
    writeRecords<std::uint8_t>(file, cellCount(),
                               [](auto, auto types) { std::ranges::fill(types, kVoxel); });
    detail::writeVtkArrays(file, arrays);
    file.write(detail::VtkXml::kEnd);
  }

 private:
  using Connectivity = std::array<Index, kCorners>;

  [[nodiscard]] std::size_t cellCount() const { return mesh_.cells().size(); }

  [[nodiscard]] std::string header(std::span<const VtkArray> arrays) const {
    using detail::toText;
    using detail::vtkType;
    const auto cells = cellCount();
    detail::VtkXml xml("UnstructuredGrid");
    xml.patchNames(options_.patchNames);
    xml.open("Piece", {{"NumberOfPoints", toText(static_cast<long long>(nodes_.count()))},
                       {"NumberOfCells", toText(static_cast<long long>(cells))}});
    xml.open("Points");
    xml.array("Points", vtkType<T>(), 3, nodes_.count() * sizeof(Vec3<T>));
    xml.close("Points");
    xml.open("Cells");
    xml.array("connectivity", vtkType<Index>(), 1, cells * sizeof(Connectivity));
    xml.array("offsets", vtkType<Index>(), 1, cells * sizeof(Index));
    xml.array("types", vtkType<std::uint8_t>(), 1, cells);
    xml.close("Cells");
    xml.empty("PointData");
    xml.arrays("CellData", arrays);
    xml.close("Piece");
    return xml.finished();
  }

  /// Writes an array of `count` records, filled in by make(number of the first, span of records).
  template <typename Record, typename Make>
  void writeRecords(OutputFile& file, std::size_t count, const Make& make) const {
    detail::writeVtkSize(file, count * sizeof(Record));
    std::vector<Record> records(std::min(count, kStretch));
    for (std::size_t first = 0; first < count; first += kStretch) {
      const auto some = std::span(records).first(std::min(kStretch, count - first));
      parallelFor(some.size(), {.threads = options_.threads, .grain = kGrain},
                  [&](std::size_t begin, std::size_t end) {
                    make(first + begin, some.subspan(begin, end - begin));
                  });
      file.write(std::as_bytes(some));
    }
  }

  void writeCorners(std::size_t first, std::span<Connectivity> cells) const {
    std::vector<typename OctreeNodes<T>::Corners> corners(cells.size());
    nodes_.corners(first, corners);
    for (std::size_t n = 0; n < cells.size(); ++n) {
      std::ranges::transform(corners[n], cells[n].begin(),
                             [](std::uint64_t node) { return static_cast<Index>(node); });
    }
  }

  const OctreeCells<T>& mesh_;
  const OctreeNodes<T>& nodes_;
  const VtuOptions& options_;
};

}  // namespace

template <std::floating_point T>
void detail::writeVtu(OutputFile& file, const OctreeCells<T>& mesh,
                      std::span<const VtkArray> arrays, const VtuOptions& options) {
  require(options.threads >= 0, "writeVtu: need threads >= 0", Named{"threads", options.threads});
  checkVtkArrays("writeVtu", arrays, mesh.cells().size());
  const OctreeNodes<T> nodes(mesh, {.threads = options.threads});
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  const bool isWide = options.wideIndices || kCorners * mesh.cells().size() > kMost;
  if (isWide) {
    VtuWriter<T, std::int64_t>(mesh, nodes, options).write(file, arrays);
  } else {
    VtuWriter<T, std::int32_t>(mesh, nodes, options).write(file, arrays);
  }
}

template <std::floating_point T>
void writeVtu(const std::filesystem::path& path, const OctreeCells<T>& mesh,
              std::span<const VtkArray> arrays, const VtuOptions& options) {
  OutputFile file(path);
  detail::writeVtu(file, mesh, arrays, options);
  file.commit();
}

template void detail::writeVtu(OutputFile&, const OctreeCells<float>&, std::span<const VtkArray>,
                               const VtuOptions&);
template void detail::writeVtu(OutputFile&, const OctreeCells<double>&, std::span<const VtkArray>,
                               const VtuOptions&);
template void writeVtu(const std::filesystem::path&, const OctreeCells<float>&,
                       std::span<const VtkArray>, const VtuOptions&);
template void writeVtu(const std::filesystem::path&, const OctreeCells<double>&,
                       std::span<const VtkArray>, const VtuOptions&);

}  // namespace cutwater
