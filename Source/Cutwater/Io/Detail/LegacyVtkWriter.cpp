#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <limits>

// Legacy VTK, version 3, binary, with all arrays as fields. (VTK User's Guide, "VTK File Formats".)

namespace cutwater::detail {

namespace {

std::string encodedName(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string result;
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (code > ' ' && code < 127 && c != '%' && c != '"') {
      result += c;
    } else {
      result.append("%").append(1, kDigits[code / 16]).append(1, kDigits[code % 16]);
    }
  }
  return result;
}

class LegacyVtkWriter {
 public:
  LegacyVtkWriter(text::Output& out, const PointData& data) : out_(out), data_(data) {}

  void write() {
    const bool isUnstructured = data_.mesh == DataMesh::Unstructured;
    out_ << "# vtk DataFile Version 3.0\nCutwater\nBINARY\nDATASET "
         << (isUnstructured ? "UNSTRUCTURED_GRID\n" : "POLYDATA\n");
    writeArrays(data_.fieldArrays);
    writePoints();
    if (isUnstructured) {
      writeCells("CELLS", 0, data_.cells.count());
      writeKinds();
    } else {
      writeParts();
    }
    if (!data_.cellArrays.empty()) {
      out_ << "CELL_DATA " << std::uint64_t{data_.cells.count()} << '\n';
      writeArrays(data_.cellArrays);
    }
    if (!data_.pointArrays.empty()) {
      out_ << "POINT_DATA " << std::uint64_t{data_.points.size()} << '\n';
      writeArrays(data_.pointArrays);
    }
  }

 private:
  void writePoints() {
    out_ << "POINTS " << std::uint64_t{data_.points.size()}
         << (data_.singlePrecision ? " float\n" : " double\n");
    for (const auto& p : data_.points) {
      for (int axis = 0; axis < 3; ++axis) {
        if (data_.singlePrecision) {
          out_.binaryBigEndian(static_cast<float>(p[axis]));
        } else {
          out_.binaryBigEndian(p[axis]);
        }
      }
    }
    out_ << '\n';
  }

  /// Vertices, lines, polygons and strips, which stand in this order.
  void writeParts() {
    struct Part {
      std::string_view keyword;
      std::uint8_t kind;
    };
    constexpr std::array<Part, 4> kParts{
        {{"VERTICES", 2}, {"LINES", 4}, {"POLYGONS", 7}, {"TRIANGLE_STRIPS", 6}}};
    const auto& kinds = data_.cells.kinds;
    std::size_t first = 0;
    for (const auto& [keyword, kind] : kParts) {
      std::size_t end = first;
      while (end < kinds.size() && kinds[end] == kind) ++end;
      if (end > first) writeCells(keyword, first, end);
      first = end;
    }
  }

  void writeCells(std::string_view keyword, std::size_t first, std::size_t end) {
    const auto numbers = end - first + data_.cells.offsets[end] - data_.cells.offsets[first];
    out_ << keyword << ' ' << std::uint64_t{end - first} << ' ' << std::uint64_t{numbers} << '\n';
    for (std::size_t i = first; i < end; ++i) {
      const auto corners = data_.cells.cell(i);
      out_.binaryBigEndian(static_cast<std::uint32_t>(corners.size()));
      for (const auto corner : corners) out_.binaryBigEndian(static_cast<std::uint32_t>(corner));
    }
    out_ << '\n';
  }

  void writeKinds() {
    out_ << "CELL_TYPES " << std::uint64_t{data_.cells.count()} << '\n';
    for (const auto kind : data_.cells.kinds) {
      out_.binaryBigEndian(static_cast<std::uint32_t>(kind));
    }
    out_ << '\n';
  }

  void writeArrays(const std::vector<DataArray>& arrays) {
    constexpr std::array<std::string_view, 10> kTypes{
        "char",         "unsigned_char", "short",         "unsigned_short", "int",
        "unsigned_int", "long",          "unsigned_long", "float",          "double"};
    if (arrays.empty()) return;
    out_ << "FIELD FieldData " << std::uint64_t{arrays.size()} << '\n';
    for (const auto& [name, numbers, components] : arrays) {
      out_ << encodedName(name) << ' ' << std::uint64_t{components} << ' '
           << std::uint64_t{numberCount(numbers) / components} << ' '
           << kTypes[static_cast<std::size_t>(typeOf(numbers))] << '\n';
      std::visit(
          [this](const auto& values) {
            for (const auto value : values) out_.binaryBigEndian(value);
          },
          numbers);
      out_ << '\n';
    }
  }

  text::Output& out_;
  const PointData& data_;
};

}  // namespace

void requireFitsLegacyVtk(const PointData& data, const std::string& name) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  const auto& cells = data.cells;
  if (std::ranges::count(cells.kinds, kVtkPolyhedron) > 0) {
    throw Error(ErrorKind::Argument, name + ": polyhedra are written as .vtu only");
  }
  if (data.points.size() > kMost || cells.count() + cells.corners.size() > kMost) {
    throw Error(ErrorKind::Limit, name + ": legacy VTK counts to 2^31 - 1 only");
  }
}

void writeLegacyVtk(text::Output& out, const PointData& data) {
  LegacyVtkWriter(out, data).write();
}

}  // namespace cutwater::detail
