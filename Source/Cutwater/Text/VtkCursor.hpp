#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Text/ByteCursor.hpp>
#include <Cutwater/Text/TextCursor.hpp>

namespace cutwater::text {

/// Walks through a legacy VTK file: keywords are text; arrays are text or big-endian binary. Up to
/// version 4 a cell is a count followed by its points; from version 5 on the cells are an array of
/// offsets and one of points. (VTK User's Guide, "VTK File Formats"; version 5.1 as vtkDataWriter
/// writes it.)
class VtkCursor {
 public:
  /// Cells of one kind, as a caller takes them.
  struct CellVisitor {
    std::uint64_t fewest = 0;  ///< corners that a cell must have
    /// Called once before the first, with their number and that of all their corners.
    FunctionRef<void(std::uint64_t cells, std::uint64_t corners)> begin;
    /// Called for each; reads all its corners by integer(type).
    FunctionRef<void(ScalarType type, std::uint64_t corners)> cell;
  };
  /// The words and counts that announce an array of a FIELD.
  struct Field {
    std::string_view name;
    std::uint64_t components = 0;
    std::uint64_t tuples = 0;
    ScalarType type{};
  };

  explicit VtkCursor(const Content& content) : text_(content), bytes_(content, std::endian::big) {}

  /// Reads the lines up to the encoding. @throws Error(File) for versions before 1 or beyond 5.1.
  void readHeader();
  [[nodiscard]] bool isBinary() const { return isBinary_; }

  /// The cursor over keywords, and that over numbers, for messages about them.
  [[nodiscard]] TextCursor& text() { return text_; }
  [[nodiscard]] const Cursor& numbers() const {
    return isBinary_ ? static_cast<const Cursor&>(bytes_) : text_;
  }

  /// Whether the words are the same but for their case, which the format ignores.
  [[nodiscard]] static bool is(std::string_view word, std::string_view keyword);
  /// The next word of the line, which names a type of numbers.
  ScalarType scalarType();
  /// The least that a number takes in the file, in bytes.
  [[nodiscard]] std::uint64_t smallest(ScalarType type) const {
    return isBinary_ ? sizeOf(type) : 2;
  }

  /// Begin and end an array: binary data begin after the line that announces them.
  void beginData() {
    if (isBinary_) bytes_.seek(text_.nextLineBegin());
  }
  void endData() {
    if (isBinary_) text_.seek(bytes_.position());
  }
  /// Messages about binary data name the byte at which this was called last.
  void beginRecord() { bytes_.beginRecord(); }
  double number(ScalarType type) {
    return isBinary_ ? bytes_.number(type) : text_.toNumber(text_.wordOfFile());
  }
  std::int64_t integer(ScalarType type) {
    return isBinary_ ? bytes_.integer(type) : text_.toInteger(text_.wordOfFile());
  }

  /// Reads what follows a keyword such as POLYGONS.
  void readCells(const CellVisitor& visitor);
  /// Reads what follows the keyword FIELD. `visit` is called behind beginData() of each array that
  /// has components, and reads components * tuples numbers.
  void readFields(FunctionRef<void(const Field&)> visit);
  /// Skips what follows the keyword METADATA: up to the next blank line.
  void skipMetadata();

 private:
  void readCellsByCounts(const CellVisitor& visitor, std::int64_t cells, std::int64_t numbers);
  void readCellsByOffsets(const CellVisitor& visitor, std::int64_t offsets, std::int64_t points);
  [[noreturn]] void failTooFew(std::uint64_t cells, std::uint64_t found, const std::string& what,
                               std::uint64_t needed) const;
  ScalarType arrayHeader(std::string_view name);

  TextCursor text_;
  ByteCursor bytes_;
  bool isBinary_ = false;
  bool offsetsApart_ = false;
};

}  // namespace cutwater::text
