#include <Cutwater/Surface/Formats/Readers.hpp>

#include <array>
#include <utility>
#include <vector>

namespace cutwater::formats {

namespace {

// Legacy VTK, POLYDATA only. Keywords are text; arrays are text or big-endian binary. Up to version
// 4 a cell is a count followed by its points; from version 5 on the cells are an array of offsets
// and one of points. (VTK User's Guide, "VTK File Formats"; version 5.1 as vtkDataWriter writes
// it.)
class VtkReader {
 public:
  VtkReader(const Content& content, SoupBuilder& builder)
      : text_(content), bytes_(content, std::endian::big), builder_(builder) {}

  SurfaceFile read() {
    readHeader();
    for (auto keyword = text_.wordOfFileOrNone(); !keyword.empty();
         keyword = text_.wordOfFileOrNone()) {
      // The data that follow belong to the points and cells already read, and are discarded.
      if (is(keyword, "POINT_DATA") || is(keyword, "CELL_DATA")) break;
      readSection(keyword);
    }
    if (skipped_ > 0) {
      builder_.note(std::to_string(skipped_) + " points and lines (VERTICES, LINES) are not read.");
    }
    return std::move(builder_).finish(text_);
  }

 private:
  enum class Cells { Skipped, Polygons, Strips };

  static bool is(std::string_view word, std::string_view keyword) {
    return equalIgnoringCase(word, keyword);
  }

  void readHeader() {
    text_.nextLine();
    for (const char* expected : {"#", "vtk", "DataFile", "Version"}) {
      if (!is(text_.word(), expected)) text_.fail("expected # vtk DataFile Version x.y");
    }
    const double version = text_.number();
    if (!(version >= 1 && version < 5.2)) text_.fail("legacy VTK is read up to version 5.1");
    offsetsApart_ = version >= 5;
    text_.nextLine();  // a title
    if (!text_.nextLine()) text_.fail("the file ends too early");
    const auto encoding = text_.word();
    binary_ = is(encoding, "BINARY");
    if (!binary_ && !is(encoding, "ASCII")) text_.fail("expected ASCII or BINARY");
    builder_.report().binary = binary_;
    if (binary_) text_.reportBytes();
  }

  // The format has each section once, and the reserved memory relies on that.
  void requireFirst(std::string_view keyword) {
    for (const auto before : sections_) {
      if (is(keyword, before)) text_.fail("a second " + inQuotes(keyword));
    }
    sections_.push_back(keyword);
  }

  void readSection(std::string_view keyword) {
    if (is(keyword, "DATASET")) {
      const auto type = text_.word();
      if (!is(type, "POLYDATA")) text_.fail("expected POLYDATA, found " + inQuotes(type));
    } else if (is(keyword, "POINTS")) {
      readPoints();
    } else if (is(keyword, "VERTICES") || is(keyword, "LINES")) {
      requireFirst(keyword);
      readCells(Cells::Skipped);
    } else if (is(keyword, "POLYGONS")) {
      requireFirst(keyword);
      readCells(Cells::Polygons);
    } else if (is(keyword, "TRIANGLE_STRIPS")) {
      requireFirst(keyword);
      readCells(Cells::Strips);
    } else if (is(keyword, "METADATA")) {
      skipMetadata();
    } else if (is(keyword, "FIELD")) {
      skipFields();
    } else {
      text_.fail("unknown keyword " + inQuotes(keyword));
    }
  }

  void readPoints() {
    requireFirst("POINTS");
    const std::int64_t promised = text_.integer();
    const ScalarType type = scalarType();
    const auto count = text_.requireRecords(promised, 3 * smallest(type), "points");
    builder_.reservePoints(count);
    beginData();
    for (std::uint64_t i = 0; i < count; ++i) {
      bytes_.beginRecord();
      const double x = number(type);
      const double y = number(type);
      const double z = number(type);
      builder_.addPoint({x, y, z}, cursor());
    }
    endData();
  }

  void readCells(Cells kind) {
    const std::int64_t first = text_.integer();
    const std::int64_t second = text_.integer();
    if (offsetsApart_) {
      readCellsByOffsets(kind, first, second);
    } else {
      readCellsByCounts(kind, first, second);
    }
  }

  // "POLYGONS cells numbers", then for each cell the number of its points and the points.
  void readCellsByCounts(Cells kind, std::int64_t cellsPromised, std::int64_t numbersPromised) {
    constexpr ScalarType kInt = ScalarType::Int32;
    const std::uint64_t fewest = kind == Cells::Skipped ? 1 : 4;
    const auto cells = text_.requireRecords(cellsPromised, fewest * smallest(kInt), "cells");
    std::uint64_t left = text_.requireRecords(numbersPromised, smallest(kInt), "cell numbers");
    if (left < cells * fewest) failTooFew(cells, left, "numbers", cells * fewest);
    reserve(kind, cells, left - cells);
    beginData();
    for (std::uint64_t i = 0; i < cells; ++i) {
      bytes_.beginRecord();
      const auto corners = static_cast<std::uint64_t>(integer(kInt));  // negative: huge
      if (left == 0) {
        cursor().fail("no numbers are left for cell " + std::to_string(i) + " of " +
                      std::to_string(cells));
      }
      left -= 1;
      if (corners > left) {
        cursor().fail("a cell of " + std::to_string(static_cast<std::int64_t>(corners)) +
                      " points, but only " + std::to_string(left) + " of the numbers are left");
      }
      left -= corners;
      readCell(kind, kInt, corners);
    }
    if (left > 0) {
      cursor().fail("the cells leave " + std::to_string(left) + " of the " +
                    std::to_string(numbersPromised) + " numbers that the header promises");
    }
    endData();
  }

  // "POLYGONS offsets points", then the two arrays, each with its number type. The first offset is
  // 0 and the last the number of points; without cells there may be no offset at all.
  void readCellsByOffsets(Cells kind, std::int64_t offsetsPromised, std::int64_t pointsPromised) {
    const ScalarType offsetType = arrayHeader("OFFSETS");
    const auto count = text_.requireRecords(offsetsPromised, smallest(offsetType), "offsets");
    const std::uint64_t fewest = kind == Cells::Skipped ? 0 : 3;
    std::vector<std::uint64_t> offsets;
    offsets.reserve(count);
    beginData();
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto offset = static_cast<std::uint64_t>(integer(offsetType));
      const bool fits = i == 0 ? offset == 0 : offset >= offsets.back();
      if (!fits) cursor().fail("offsets must begin with 0 and ascend");
      offsets.push_back(offset);
    }
    endData();
    const ScalarType type = arrayHeader("CONNECTIVITY");
    const auto points = text_.requireRecords(pointsPromised, smallest(type), "cell points");
    const std::uint64_t last = offsets.empty() ? 0 : offsets.back();
    if (last != points) {
      text_.fail("the last offset is " + std::to_string(last) +
                 ", not the number of cell points, " + std::to_string(points));
    }
    const std::uint64_t cells = offsets.empty() ? 0 : count - 1;
    if (cells > 0 && points / cells < fewest) failTooFew(cells, points, "points", cells * fewest);
    reserve(kind, cells, points);
    beginData();
    for (std::uint64_t i = 0; i < cells; ++i) {
      bytes_.beginRecord();
      readCell(kind, type, offsets[i + 1] - offsets[i]);
    }
    endData();
  }

  [[noreturn]] void failTooFew(std::uint64_t cells, std::uint64_t found, const std::string& what,
                               std::uint64_t needed) const {
    text_.fail(std::to_string(cells) + " cells with only " + std::to_string(found) + " " + what +
               ", and they take " + std::to_string(needed) + " at least");
  }

  ScalarType arrayHeader(std::string_view name) {
    const auto found = text_.wordOfFile();
    if (!is(found, name)) text_.fail("expected " + inQuotes(name) + ", found " + inQuotes(found));
    const ScalarType type = scalarType();
    // Narrow types would let a small file request much memory; VTK does not write them.
    if (!isInteger(type) || sizeOf(type) < 4) text_.fail("expected an array of indices");
    return type;
  }

  // A strip of n corners is n - 2 triangles.
  void reserve(Cells kind, std::uint64_t cells, std::uint64_t corners) {
    if (kind == Cells::Polygons) builder_.reservePolygons(cells, corners);
    if (kind == Cells::Strips) {
      const std::uint64_t triangles = corners - 2 * cells;
      builder_.reservePolygons(triangles, 3 * triangles);
    }
  }

  void readCell(Cells kind, ScalarType type, std::uint64_t corners) {
    if (kind == Cells::Skipped) {
      for (std::uint64_t i = 0; i < corners; ++i) static_cast<void>(integer(type));
      ++skipped_;
    } else if (kind == Cells::Polygons) {
      for (std::uint64_t i = 0; i < corners; ++i) builder_.addCorner(integer(type), cursor());
      builder_.endPolygon(cursor());
    } else {
      readStrip(type, corners);
    }
  }

  // Every second triangle of a strip has the opposite orientation.
  void readStrip(ScalarType type, std::uint64_t corners) {
    if (corners < 3) cursor().fail("a strip has " + std::to_string(corners) + " points");
    std::array<std::int64_t, 2> last = {integer(type), 0};
    last[1] = integer(type);
    for (std::uint64_t i = 2; i < corners; ++i) {
      const std::int64_t next = integer(type);
      const bool turned = i % 2 == 1;
      builder_.addCorner(last[turned ? 1 : 0], cursor());
      builder_.addCorner(last[turned ? 0 : 1], cursor());
      builder_.addCorner(next, cursor());
      builder_.endPolygon(cursor());
      last = {last[1], next};
    }
  }

  // Skips to the next blank line.
  void skipMetadata() {
    while (text_.nextLine()) {
      if (text_.word().empty()) return;
    }
  }

  // "FIELD name arrays", then for each array "name components tuples type" and the numbers.
  void skipFields() {
    static_cast<void>(text_.word());
    const auto arrays = text_.requireRecords(text_.integer(), 8, "arrays");
    for (std::uint64_t array = 0; array < arrays; ++array) {
      static_cast<void>(text_.wordOfFile());
      const std::int64_t components = text_.integer();
      const std::int64_t tuples = text_.integer();
      const ScalarType type = scalarType();
      const auto width = text_.requireRecords(components, smallest(type), "components");
      const auto count = text_.requireRecords(tuples, width * smallest(type), "tuples");
      beginData();
      for (std::uint64_t i = 0; width > 0 && i < width * count; ++i) number(type);
      endData();
    }
  }

  ScalarType scalarType() {
    constexpr std::array<std::pair<std::string_view, ScalarType>, 12> kNames = {{
        {"char", ScalarType::Int8},
        {"unsigned_char", ScalarType::UInt8},
        {"short", ScalarType::Int16},
        {"unsigned_short", ScalarType::UInt16},
        {"int", ScalarType::Int32},
        {"vtkIdType", ScalarType::Int32},
        {"unsigned_int", ScalarType::UInt32},
        {"long", ScalarType::Int64},
        {"vtktypeint64", ScalarType::Int64},
        {"unsigned_long", ScalarType::UInt64},
        {"float", ScalarType::Float32},
        {"double", ScalarType::Float64},
    }};
    const auto word = text_.word();
    for (const auto& [name, type] : kNames) {
      if (is(word, name)) return type;
    }
    text_.fail("unknown number type " + inQuotes(word));
  }

  [[nodiscard]] std::uint64_t smallest(ScalarType type) const { return binary_ ? sizeOf(type) : 2; }
  [[nodiscard]] const Cursor& cursor() const {
    return binary_ ? static_cast<const Cursor&>(bytes_) : text_;
  }

  double number(ScalarType type) {
    return binary_ ? bytes_.number(type) : text_.toNumber(text_.wordOfFile());
  }
  std::int64_t integer(ScalarType type) {
    return binary_ ? bytes_.integer(type) : text_.toInteger(text_.wordOfFile());
  }

  // Binary data begin after the line that announces them.
  void beginData() {
    if (binary_) bytes_.seek(text_.nextLineBegin());
  }
  void endData() {
    if (binary_) text_.seek(bytes_.position());
  }

  TextCursor text_;
  ByteCursor bytes_;
  SoupBuilder& builder_;
  bool binary_ = false;
  bool offsetsApart_ = false;
  std::uint64_t skipped_ = 0;
  std::vector<std::string_view> sections_;
};

}  // namespace

SurfaceFile readVtk(const Content& content, SoupBuilder& builder) {
  return VtkReader(content, builder).read();
}

}  // namespace cutwater::formats
