#include <Cutwater/Io/Detail/LegacyVtkArrays.hpp>
#include <Cutwater/Text/Words.hpp>

// Legacy VTK, POLYDATA and UNSTRUCTURED_GRID, with all arrays of numbers.

namespace cutwater::detail {

namespace {

using text::inQuotes;
using text::ScalarType;
using text::VtkCursor;

class LegacyVtkReader {
 public:
  explicit LegacyVtkReader(const text::Content& content) : file_(content) {}

  PointData read() {
    file_.readHeader();
    data_.isBinary = file_.isBinary();
    for (auto keyword = text().wordOfFileOrNone(); !keyword.empty();
         keyword = text().wordOfFileOrNone()) {
      if (!readStructure(keyword) && !arrays_.read(keyword)) {
        text().fail("unknown keyword " + inQuotes(keyword));
      }
    }
    finish();
    return std::move(data_);
  }

 private:
  /// Cells of one keyword.
  struct Cells {
    std::string_view keyword;
    std::uint8_t kind = 0;  ///< of them all; 0: CELL_TYPES has the kinds
    DataCells cells = {};
    bool isRead = false;
  };

  static bool is(std::string_view word, std::string_view keyword) {
    return VtkCursor::is(word, keyword);
  }
  text::TextCursor& text() { return file_.text(); }

  bool readStructure(std::string_view keyword) {
    if (is(keyword, "DATASET")) {
      readDataset();
    } else if (is(keyword, "POINTS")) {
      readPoints();
    } else if (is(keyword, "CELL_TYPES")) {
      readKinds();
    } else if (is(keyword, "METADATA")) {
      file_.skipMetadata();
    } else if (is(keyword, "POINT_DATA")) {
      arrays_.begin(data_.pointArrays, data_.points.size());
    } else if (is(keyword, "CELL_DATA")) {
      arrays_.begin(data_.cellArrays, cellCount());
    } else {
      return readCells(keyword);
    }
    return true;
  }

  void readDataset() {
    const auto type = text().word();
    if (data_.mesh != DataMesh::Points) text().fail("a second data set");
    if (is(type, "POLYDATA")) {
      data_.mesh = DataMesh::PolyData;
    } else if (is(type, "UNSTRUCTURED_GRID")) {
      data_.mesh = DataMesh::Unstructured;
    } else {
      text().fail("expected POLYDATA or UNSTRUCTURED_GRID, found " + inQuotes(type));
    }
  }

  void readPoints() {
    if (hasPoints_) text().fail("a second \"POINTS\"");
    if (data_.mesh == DataMesh::Points) text().fail("POINTS before DATASET");
    hasPoints_ = true;
    const std::int64_t promised = text().integer();
    const ScalarType type = file_.scalarType();
    const auto count = text().requireRecords(promised, 3 * file_.smallest(type), "points");
    data_.singlePrecision = type == ScalarType::Float32;
    data_.points.resize(count);
    file_.beginData();
    for (auto& p : data_.points) {
      file_.beginRecord();
      p.x = file_.number(type);
      p.y = file_.number(type);
      p.z = file_.number(type);
      if (!isFinite(p)) file_.numbers().fail("a coordinate is not finite");
    }
    file_.endData();
  }

  bool readCells(std::string_view keyword) {
    for (auto& part : parts_) {
      if (!is(keyword, part.keyword)) continue;
      if (part.isRead) text().fail("a second " + inQuotes(keyword));
      if ((part.kind == 0) != (data_.mesh == DataMesh::Unstructured)) {
        text().fail(inQuotes(keyword) + " in another kind of data set");
      }
      part.isRead = true;
      auto& cells = part.cells;
      file_.readCells({.fewest = 0,
                       .begin =
                           [&](std::uint64_t count, std::uint64_t all) {
                             cells.kinds.assign(count, part.kind);
                             cells.offsets.reserve(count + 1);
                             cells.corners.reserve(all);
                           },
                       .cell =
                           [&](ScalarType type, std::uint64_t count) {
                             for (std::uint64_t i = 0; i < count; ++i) {
                               const auto index = file_.integer(type);
                               cells.corners.push_back(check_.checked(index, file_.numbers()));
                             }
                             cells.offsets.push_back(cells.corners.size());
                           }});
      return true;
    }
    return false;
  }

  void readKinds() {
    constexpr ScalarType kInt = ScalarType::Int32;
    constexpr std::int64_t kPolyhedron = 42;
    if (data_.mesh != DataMesh::Unstructured) text().fail("kinds of cells of POLYDATA");
    if (hasKinds_) text().fail("a second \"CELL_TYPES\"");
    hasKinds_ = true;
    const auto count =
        text().requireRecords(text().integer(), file_.smallest(kInt), "kinds of cells");
    kinds_.resize(count);
    file_.beginData();
    for (auto& kind : kinds_) {
      file_.beginRecord();
      const auto value = file_.integer(kInt);
      if (value < 0 || value > 255) {
        file_.numbers().fail("there is no kind of cells " + std::to_string(value));
      }
      if (value == kPolyhedron) file_.numbers().fail("polyhedra are read from .vtu only");
      kind = static_cast<std::uint8_t>(value);
    }
    file_.endData();
  }

  [[nodiscard]] std::size_t cellCount() const {
    std::size_t count = 0;
    for (const auto& part : parts_) count += part.cells.count();
    return count;
  }

  /// Puts the cells together, and makes the checks that need all of the file.
  void finish() {
    if (!hasPoints_) text().fail("the file ends without POINTS");
    check_.requireBelow(data_.points.size(), text());
    auto& [kinds, offsets, corners, faces, faceEnds] = data_.cells;
    for (auto& part : parts_) {
      if (kinds.empty()) {
        data_.cells = std::move(part.cells);
        continue;
      }
      const auto before = corners.size();
      kinds.insert(kinds.end(), part.cells.kinds.begin(), part.cells.kinds.end());
      for (std::size_t i = 1; i < part.cells.offsets.size(); ++i) {
        offsets.push_back(before + part.cells.offsets[i]);
      }
      corners.insert(corners.end(), part.cells.corners.begin(), part.cells.corners.end());
      part.cells = {};
    }
    if (data_.mesh != DataMesh::Unstructured) return;
    if (kinds_.size() != kinds.size()) {
      text().fail(std::to_string(kinds_.size()) + " kinds of cells for " +
                  std::to_string(kinds.size()) + " cells");
    }
    kinds = std::move(kinds_);
  }

  VtkCursor file_;
  PointData data_;
  LegacyVtkArrays arrays_{file_, data_};
  std::array<Cells, 5> parts_ = {
      {{"VERTICES", 2}, {"LINES", 4}, {"POLYGONS", 7}, {"TRIANGLE_STRIPS", 6}, {"CELLS", 0}}};
  CornerCheck check_;
  std::vector<std::uint8_t> kinds_;
  bool hasPoints_ = false;
  bool hasKinds_ = false;
};

}  // namespace

PointData readLegacyVtk(const text::Content& content, std::uint64_t /*maxBytes*/) {
  return LegacyVtkReader(content).read();
}

}  // namespace cutwater::detail
