#include <Cutwater/Surface/Formats/Readers.hpp>
#include <Cutwater/Text/VtkCursor.hpp>

#include <utility>
#include <vector>

namespace cutwater::formats {

namespace {

using text::VtkCursor;

// Legacy VTK, POLYDATA only.
class VtkReader {
 public:
  VtkReader(const Content& content, SoupBuilder& builder) : file_(content), builder_(builder) {}

  SurfaceFile read() {
    file_.readHeader();
    builder_.report().binary = file_.isBinary();
    for (auto keyword = text().wordOfFileOrNone(); !keyword.empty();
         keyword = text().wordOfFileOrNone()) {
      // The data that follow belong to the points and cells already read, and are discarded.
      if (is(keyword, "POINT_DATA") || is(keyword, "CELL_DATA")) break;
      readSection(keyword);
    }
    if (skipped_ > 0) {
      builder_.note(std::to_string(skipped_) + " points and lines (VERTICES, LINES) are not read.");
    }
    return std::move(builder_).finish(text());
  }

 private:
  enum class Cells { Skipped, Polygons, Strips };

  static bool is(std::string_view word, std::string_view keyword) {
    return VtkCursor::is(word, keyword);
  }
  TextCursor& text() { return file_.text(); }

  // The format has each section once, and the reserved memory relies on that.
  void requireFirst(std::string_view keyword) {
    for (const auto before : sections_) {
      if (is(keyword, before)) text().fail("a second " + inQuotes(keyword));
    }
    sections_.push_back(keyword);
  }

  void readSection(std::string_view keyword) {
    if (is(keyword, "DATASET")) {
      const auto type = text().word();
      if (!is(type, "POLYDATA")) text().fail("expected POLYDATA, found " + inQuotes(type));
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
      file_.skipMetadata();
    } else if (is(keyword, "FIELD")) {
      file_.readFields([this](const VtkCursor::Field& field) {
        for (std::uint64_t i = 0; i < field.components * field.tuples; ++i) {
          file_.number(field.type);
        }
      });
    } else {
      text().fail("unknown keyword " + inQuotes(keyword));
    }
  }

  void readPoints() {
    requireFirst("POINTS");
    const std::int64_t promised = text().integer();
    const ScalarType type = file_.scalarType();
    const auto count = text().requireRecords(promised, 3 * file_.smallest(type), "points");
    builder_.reservePoints(count);
    file_.beginData();
    for (std::uint64_t i = 0; i < count; ++i) {
      file_.beginRecord();
      const double x = file_.number(type);
      const double y = file_.number(type);
      const double z = file_.number(type);
      builder_.addPoint({x, y, z}, file_.numbers());
    }
    file_.endData();
  }

  void readCells(Cells kind) {
    file_.readCells({.fewest = kind == Cells::Skipped ? 0U : 3U,
                     .begin = [=, this](std::uint64_t cells,
                                        std::uint64_t corners) { reserve(kind, cells, corners); },
                     .cell = [=, this](ScalarType type,
                                       std::uint64_t corners) { readCell(kind, type, corners); }});
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
      for (std::uint64_t i = 0; i < corners; ++i) static_cast<void>(file_.integer(type));
      ++skipped_;
    } else if (kind == Cells::Polygons) {
      for (std::uint64_t i = 0; i < corners; ++i)
        builder_.addCorner(file_.integer(type), file_.numbers());
      builder_.endPolygon(file_.numbers());
    } else {
      for (std::uint64_t i = 0; i < corners; ++i) {
        builder_.addStripCorner(file_.integer(type), file_.numbers());
      }
      builder_.endStrip(file_.numbers());
    }
  }

  VtkCursor file_;
  SoupBuilder& builder_;
  std::uint64_t skipped_ = 0;
  std::vector<std::string_view> sections_;
};

}  // namespace

SurfaceFile readVtk(const Content& content, SoupBuilder& builder) {
  return VtkReader(content, builder).read();
}

}  // namespace cutwater::formats
