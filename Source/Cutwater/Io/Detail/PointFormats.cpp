#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <utility>

namespace cutwater::detail {

namespace {

constexpr std::size_t kNumberTypes = std::variant_size_v<DataNumbers>;
// The alternatives stand in the order of text::ScalarType.
static_assert(kNumberTypes == static_cast<std::size_t>(text::ScalarType::Float64) + 1);

template <std::size_t... types>
DataNumbers numbersAt(std::size_t type, std::size_t count, std::index_sequence<types...>) {
  DataNumbers numbers;
  static_cast<void>(((type == types && (numbers.emplace<types>(count), true)) || ...));
  return numbers;
}

[[noreturn]] void refuseData(const std::string& why) {
  throw Error(ErrorKind::Argument, "writePointData: " + why);
}

void checkDataArrays(const std::vector<DataArray>& arrays, std::size_t rows, bool anyLength) {
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    const auto& [name, numbers, components] = arrays[a];
    if (name.empty()) refuseData("every array needs a name");
    const auto isNamesake = [&, a](const DataArray& other) { return other.name == arrays[a].name; };
    if (std::any_of(arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(a), isNamesake)) {
      refuseData("two arrays named " + text::inQuotes(name));
    }
    const auto length = numberCount(numbers);
    const bool fits =
        components > 0 && length % components == 0 && (anyLength || length / components == rows);
    if (fits) continue;
    refuseData("the array " + text::inQuotes(name) + " has " + std::to_string(length) +
               " numbers for " + std::to_string(rows) + " rows of " + std::to_string(components));
  }
}

/// Whether these numbers are those of one polyhedron: of its faces, and for each that of its
/// corners, and these.
bool isPolyhedron(std::span<const std::uint64_t> numbers, std::size_t points) {
  if (numbers.empty()) return false;
  auto faces = numbers.front();
  numbers = numbers.subspan(1);
  for (; faces > 0 && !numbers.empty(); --faces) {
    const auto corners = numbers.front();
    if (corners >= numbers.size()) return false;
    const auto areIn = std::ranges::all_of(numbers.subspan(1, corners),
                                           [&](std::uint64_t corner) { return corner < points; });
    if (!areIn) return false;
    numbers = numbers.subspan(1 + corners);
  }
  return faces == 0 && numbers.empty();
}

void checkDataCells(const PointData& data) {
  const auto& [kinds, offsets, corners, faces, faceEnds] = data.cells;
  if (data.mesh == DataMesh::Points && !kinds.empty()) refuseData("cells of a mesh of points");
  const bool areWhole = offsets.size() == kinds.size() + 1 && offsets.front() == 0 &&
                        offsets.back() == corners.size() &&
                        std::is_sorted(offsets.begin(), offsets.end());
  if (!areWhole) refuseData("the offsets of cells do not fit");
  const auto complaint = complaintAboutFaces(data.cells, data.points.size());
  if (!complaint.empty()) refuseData(complaint);
  for (const auto corner : corners) {
    if (corner < data.points.size()) continue;
    refuseData("a cell has the corner " + std::to_string(corner) + ", and there are " +
               std::to_string(data.points.size()) + " points");
  }
}

}  // namespace

DataNumbers numbersOfType(text::ScalarType type, std::size_t count) {
  return numbersAt(static_cast<std::size_t>(type), count, std::make_index_sequence<kNumberTypes>{});
}

text::ScalarType typeOf(const DataNumbers& numbers) {
  return static_cast<text::ScalarType>(numbers.index());
}

std::size_t numberCount(const DataNumbers& numbers) {
  return std::visit([](const auto& values) { return values.size(); }, numbers);
}

bool isXml(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '<';
}

std::string complaintAboutFaces(const DataCells& cells, std::size_t points) {
  const auto& ends = cells.faceEnds;
  const bool arePolyhedra = std::ranges::count(cells.kinds, kVtkPolyhedron) > 0;
  if (arePolyhedra ? ends.size() != cells.count() : !ends.empty() || !cells.faces.empty()) {
    return "polyhedra and their faces do not fit together";
  }
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto end = static_cast<std::uint64_t>(ends[i]);  // -1: huge
    const bool isOne = cells.kinds[i] == kVtkPolyhedron;
    const bool fits =
        isOne ? begin <= end && end <= cells.faces.size() &&
                    isPolyhedron(std::span(cells.faces).subspan(begin, end - begin), points)
              : ends[i] == -1;
    if (!fits) return "the faces of cell " + std::to_string(i) + " are not those of its kind";
    if (isOne) begin = end;
  }
  if (begin != cells.faces.size()) return "faces behind those of the last polyhedron";
  return {};
}

void checkPointData(const PointData& data) {
  checkDataArrays(data.pointArrays, data.points.size(), false);
  checkDataArrays(data.cellArrays, data.cells.count(), false);
  checkDataArrays(data.fieldArrays, 0, true);
  checkDataCells(data);
}

std::vector<std::string> columnNames(const DataArray& array) {
  if (array.components == 1) return {array.name};
  std::vector<std::string> names(array.components, array.name + "_");
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] += array.components == 3 ? std::string(1, "xyz"[i]) : std::to_string(i);
  }
  return names;
}

void requireNewName(const std::vector<DataArray>& arrays, std::string_view name,
                    const text::Cursor& at) {
  for (const auto& array : arrays) {
    if (array.name == name) at.fail("a second array named " + text::inQuotes(name));
  }
}

std::uint64_t CornerCheck::checked(std::int64_t index, const text::Cursor& at) {
  if (index < 0) at.fail("index " + std::to_string(index) + " is out of range");
  const auto corner = static_cast<std::uint64_t>(index);
  if (corner >= count_) {
    count_ = corner + 1;
    place_ = at.place();
  }
  return corner;
}

void CornerCheck::requireBelow(std::uint64_t points, const text::Cursor& at) const {
  if (count_ <= points) return;
  at.failAt(place_, "index " + std::to_string(count_ - 1) + " is out of range: the file has " +
                        std::to_string(points) + " points");
}

}  // namespace cutwater::detail
