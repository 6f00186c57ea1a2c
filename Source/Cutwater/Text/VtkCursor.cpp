#include <Cutwater/Text/VtkCursor.hpp>
#include <Cutwater/Text/Words.hpp>

#include <array>
#include <utility>
#include <vector>

namespace cutwater::text {

bool VtkCursor::is(std::string_view word, std::string_view keyword) {
  return equalIgnoringCase(word, keyword);
}

void VtkCursor::readHeader() {
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
  isBinary_ = is(encoding, "BINARY");
  if (!isBinary_ && !is(encoding, "ASCII")) text_.fail("expected ASCII or BINARY");
  if (isBinary_) text_.reportBytes();
  if (!isBinary_) text_.allowLongLines();
}

ScalarType VtkCursor::scalarType() {
  constexpr std::array<std::pair<std::string_view, ScalarType>, 14> kNames = {{
      {"char", ScalarType::Int8},
      {"signed_char", ScalarType::Int8},
      {"unsigned_char", ScalarType::UInt8},
      {"short", ScalarType::Int16},
      {"unsigned_short", ScalarType::UInt16},
      {"int", ScalarType::Int32},
      {"vtkIdType", ScalarType::Int32},
      {"unsigned_int", ScalarType::UInt32},
      {"long", ScalarType::Int64},
      {"vtktypeint64", ScalarType::Int64},
      {"unsigned_long", ScalarType::UInt64},
      {"vtktypeuint64", ScalarType::UInt64},
      {"float", ScalarType::Float32},
      {"double", ScalarType::Float64},
  }};
  const auto word = text_.word();
  for (const auto& [name, type] : kNames) {
    if (is(word, name)) return type;
  }
  text_.fail("unknown number type " + inQuotes(word));
}

void VtkCursor::readCells(const CellVisitor& visitor) {
  const std::int64_t first = text_.integer();
  const std::int64_t second = text_.integer();
  if (offsetsApart_) {
    readCellsByOffsets(visitor, first, second);
  } else {
    readCellsByCounts(visitor, first, second);
  }
}

// "POLYGONS cells numbers", then for each cell the number of its points and the points.
void VtkCursor::readCellsByCounts(const CellVisitor& visitor, std::int64_t cellsPromised,
                                  std::int64_t numbersPromised) {
  constexpr ScalarType kInt = ScalarType::Int32;
  const std::uint64_t fewest = 1 + visitor.fewest;
  const auto cells = text_.requireRecords(cellsPromised, fewest * smallest(kInt), "cells");
  std::uint64_t left = text_.requireRecords(numbersPromised, smallest(kInt), "cell numbers");
  if (left < cells * fewest) failTooFew(cells, left, "numbers", cells * fewest);
  visitor.begin(cells, left - cells);
  beginData();
  for (std::uint64_t i = 0; i < cells; ++i) {
    bytes_.beginRecord();
    const auto corners = static_cast<std::uint64_t>(integer(kInt));  // negative: huge
    if (left == 0) {
      numbers().fail("no numbers are left for cell " + std::to_string(i) + " of " +
                     std::to_string(cells));
    }
    left -= 1;
    if (corners > left) {
      numbers().fail("a cell of " + std::to_string(static_cast<std::int64_t>(corners)) +
                     " points, but only " + std::to_string(left) + " of the numbers are left");
    }
    left -= corners;
    visitor.cell(kInt, corners);
  }
  if (left > 0) {
    numbers().fail("the cells leave " + std::to_string(left) + " of the " +
                   std::to_string(numbersPromised) + " numbers that the header promises");
  }
  endData();
}

// "POLYGONS offsets points", then the two arrays, each with its number type. The first offset is
// 0 and the last the number of points; without cells there may be no offset at all.
void VtkCursor::readCellsByOffsets(const CellVisitor& visitor, std::int64_t offsetsPromised,
                                   std::int64_t pointsPromised) {
  const ScalarType offsetType = arrayHeader("OFFSETS");
  const auto count = text_.requireRecords(offsetsPromised, smallest(offsetType), "offsets");
  std::vector<std::uint64_t> offsets;
  offsets.reserve(count);
  beginData();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto offset = static_cast<std::uint64_t>(integer(offsetType));
    const bool fits = i == 0 ? offset == 0 : offset >= offsets.back();
    if (!fits) numbers().fail("offsets must begin with 0 and ascend");
    offsets.push_back(offset);
  }
  endData();
  const ScalarType type = arrayHeader("CONNECTIVITY");
  const auto points = text_.requireRecords(pointsPromised, smallest(type), "cell points");
  const std::uint64_t last = offsets.empty() ? 0 : offsets.back();
  if (last != points) {
    text_.fail("the last offset is " + std::to_string(last) + ", not the number of cell points, " +
               std::to_string(points));
  }
  const std::uint64_t cells = offsets.empty() ? 0 : count - 1;
  if (cells > 0 && points / cells < visitor.fewest) {
    failTooFew(cells, points, "points", cells * visitor.fewest);
  }
  visitor.begin(cells, points);
  beginData();
  for (std::uint64_t i = 0; i < cells; ++i) {
    bytes_.beginRecord();
    visitor.cell(type, offsets[i + 1] - offsets[i]);
  }
  endData();
}

void VtkCursor::failTooFew(std::uint64_t cells, std::uint64_t found, const std::string& what,
                           std::uint64_t needed) const {
  text_.fail(std::to_string(cells) + " cells with only " + std::to_string(found) + " " + what +
             ", and they take " + std::to_string(needed) + " at least");
}

ScalarType VtkCursor::arrayHeader(std::string_view name) {
  const auto found = text_.wordOfFile();
  if (!is(found, name)) text_.fail("expected " + inQuotes(name) + ", found " + inQuotes(found));
  const ScalarType type = scalarType();
  // Narrow types would let a small file request much memory; VTK does not write them.
  if (!isInteger(type) || sizeOf(type) < 4) text_.fail("expected an array of indices");
  return type;
}

// "FIELD name arrays", then for each array "name components tuples type" and the numbers.
void VtkCursor::readFields(FunctionRef<void(const Field&)> visit) {
  static_cast<void>(text_.word());
  const auto arrays = text_.requireRecords(text_.integer(), 8, "arrays");
  for (std::uint64_t array = 0; array < arrays; ++array) {
    auto name = text_.wordOfFile();
    while (is(name, "METADATA")) {
      skipMetadata();
      name = text_.wordOfFile();
    }
    const std::int64_t components = text_.integer();
    const std::int64_t tuples = text_.integer();
    const ScalarType type = scalarType();
    const auto width = text_.requireRecords(components, smallest(type), "components");
    const auto count = text_.requireRecords(tuples, width * smallest(type), "tuples");
    beginData();
    if (width > 0) visit({name, width, count, type});
    endData();
  }
}

void VtkCursor::skipMetadata() {
  while (text_.nextLine()) {
    if (text_.word().empty()) return;
  }
}

}  // namespace cutwater::text
