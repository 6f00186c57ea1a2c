#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Io/Detail/VtkXml.hpp>
#include <Cutwater/Io/Detail/VtkXmlNumbers.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <functional>
#include <utility>

// VTK XML with the numbers appended in raw binary.

namespace cutwater::detail {

namespace {

std::string countText(std::size_t count) {
  return std::to_string(count);
}

/// Removes the first character of a text in UTF-8; returns 0 if it is none of XML's.
char32_t takeCharacter(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t more = byte(0) < 0x80 ? 0 : byte(0) < 0xe0 ? 1 : byte(0) < 0xf0 ? 2 : 3;
  if (more >= text.size() || byte(0) >= 0xf8) return 0;
  char32_t code = more == 0 ? byte(0) : byte(0) & (0x3fU >> more);
  for (std::size_t i = 1; i <= more; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  text.remove_prefix(1 + more);
  constexpr std::array<char32_t, 4> kLeast{' ', 0x80, 0x800, 0x10000};
  const bool isSurrogate = 0xd800 <= code && code < 0xe000;
  const bool isNone = code == 0x7f || code == 0xfffe || code == 0xffff || code > 0x10ffff;
  return code < kLeast[more] || isSurrogate || isNone ? 0 : code;
}

/// Whether XML has a place for the text: UTF-8 without control characters.
bool fitsXml(std::string_view text) {
  while (!text.empty()) {
    if (takeCharacter(text) == 0) return false;
  }
  return true;
}

void requireXmlNames(const PointData& data, const std::string& file) {
  for (const auto* const arrays : {&data.pointArrays, &data.cellArrays, &data.fieldArrays}) {
    for (const auto& array : *arrays) {
      if (fitsXml(array.name)) continue;
      throw Error(ErrorKind::Argument, file + ": the name of the array " +
                                           text::inQuotes(array.name) + " is not printable UTF-8");
    }
  }
}

/// Declares arrays in the part before the numbers, and writes them behind it, in the same order.
class VtkPointWriter {
 public:
  VtkPointWriter(text::Output& out, const PointData& data, std::string_view dataSet)
      : out_(out), data_(data), xml_(dataSet) {}

  void writeUnstructured() {
    const auto& [kinds, offsets, corners, faces, faceEnds] = data_.cells;
    declareFields();
    xml_.open("Piece", {{"NumberOfPoints", countText(data_.points.size())},
                        {"NumberOfCells", countText(kinds.size())}});
    declarePoints();
    xml_.open("Cells");
    add<std::int64_t>("connectivity", corners);
    add<std::int64_t>("offsets", std::span(offsets).subspan(1));
    add<std::uint8_t>("types", kinds);
    if (!faceEnds.empty()) {
      add<std::int64_t>("faces", faces);
      add<std::int64_t>("faceoffsets", faceEnds);
    }
    xml_.close("Cells");
    finish();
  }

  void writePolyData() {
    struct Part {
      const char* element;
      const char* count;
      std::uint8_t kind;
      std::size_t first = 0;
      std::size_t end = 0;
    };
    std::array<Part, 4> parts{{{"Verts", "NumberOfVerts", 2},
                               {"Lines", "NumberOfLines", 4},
                               {"Polys", "NumberOfPolys", 7},
                               {"Strips", "NumberOfStrips", 6}}};
    const auto& kinds = data_.cells.kinds;
    std::size_t next = 0;
    for (auto& part : parts) {
      part.first = next;
      while (next < kinds.size() && kinds[next] == part.kind) ++next;
      part.end = next;
    }
    const auto countOf = [&](std::size_t i) { return countText(parts[i].end - parts[i].first); };
    declareFields();
    xml_.open("Piece", {{"NumberOfPoints", countText(data_.points.size())},
                        {parts[0].count, countOf(0)},
                        {parts[1].count, countOf(1)},
                        {parts[2].count, countOf(2)},
                        {parts[3].count, countOf(3)}});
    declarePoints();
    for (const auto& part : parts) {
      xml_.open(part.element);
      addPart(part.first, part.end);
      xml_.close(part.element);
    }
    finish();
  }

 private:
  using Write = std::function<void()>;

  void addPart(std::size_t first, std::size_t end) {
    const auto& [kinds, offsets, corners, faces, faceEnds] = data_.cells;
    const auto before = offsets[first];
    add<std::int64_t>("connectivity", std::span(corners).subspan(before, offsets[end] - before));
    const auto ends = std::span(offsets).subspan(first + 1, end - first);
    declare("offsets", text::ScalarType::Int64, 1, ends.size(), [this, ends, before] {
      for (const auto offset : ends) out_.binary(static_cast<std::int64_t>(offset - before));
    });
  }

  /// Numbers, written as another type.
  template <typename Written, typename Numbers>
  void add(std::string_view name, const Numbers& numbers) {
    const std::span values(numbers);
    const auto type = sizeof(Written) == 1 ? text::ScalarType::UInt8 : text::ScalarType::Int64;
    declare(name, type, 1, values.size(), [this, values] {
      for (const auto value : values) out_.binary(static_cast<Written>(value));
    });
  }

  void declare(std::string_view name, text::ScalarType type, std::size_t components,
               std::size_t numbers, Write write) {
    const auto bytes = numbers * text::sizeOf(type);
    xml_.array(name, vtkXmlType(type), static_cast<int>(components), bytes);
    writeLater(bytes, std::move(write));
  }

  /// Writes the number of bytes, and then these.
  void writeLater(std::uint64_t bytes, Write write) {
    writes_.push_back([this, bytes, write = std::move(write)] {
      out_.binary(bytes);
      write();
    });
  }

  void declarePoints() {
    const auto type = data_.singlePrecision ? text::ScalarType::Float32 : text::ScalarType::Float64;
    xml_.open("Points");
    declare("Points", type, 3, 3 * data_.points.size(), [this] {
      for (const auto& p : data_.points) {
        for (int axis = 0; axis < 3; ++axis) {
          if (data_.singlePrecision) {
            out_.binary(static_cast<float>(p[axis]));
          } else {
            out_.binary(p[axis]);
          }
        }
      }
    });
    xml_.close("Points");
  }

  void declareArrays(std::string_view element, const std::vector<DataArray>& arrays) {
    xml_.open(element);
    for (const auto& array : arrays) {
      declare(array.name, typeOf(array.numbers), array.components, numberCount(array.numbers),
              [this, &array] { writeNumbers(array); });
    }
    xml_.close(element);
  }

  void declareFields() {
    if (data_.fieldArrays.empty() && data_.patchNames.empty()) return;
    xml_.open("FieldData");
    for (const auto& array : data_.fieldArrays) {
      const auto type = typeOf(array.numbers);
      const auto length = numberCount(array.numbers);
      const auto bytes = length * text::sizeOf(type);
      xml_.fieldArray(array.name, vtkXmlType(type), static_cast<int>(array.components),
                      length / array.components, bytes);
      writeLater(bytes, [this, &array] { writeNumbers(array); });
    }
    xml_.patchNamesArray(data_.patchNames);
    xml_.close("FieldData");
  }

  void writeNumbers(const DataArray& array) {
    std::visit(
        [this](const auto& values) {
          for (const auto value : values) out_.binary(value);
        },
        array.numbers);
  }

  void finish() {
    declareArrays("PointData", data_.pointArrays);
    declareArrays("CellData", data_.cellArrays);
    xml_.close("Piece");
    out_ << xml_.finished();
    for (const auto& write : writes_) write();
    out_ << VtkXml::kEnd;
  }

  text::Output& out_;
  const PointData& data_;
  VtkXml xml_;
  std::vector<Write> writes_;
};

}  // namespace

void requireFitsUnstructuredXml(const PointData& data, const std::string& name) {
  requireXmlNames(data, name);
}

void requireFitsPolyDataXml(const PointData& data, const std::string& name) {
  if (data.mesh == DataMesh::Unstructured) {
    throw Error(ErrorKind::Argument,
                name + ": cells of an unstructured grid are written as .vtu, not as .vtp");
  }
  requireXmlNames(data, name);
}

void writeUnstructuredXml(text::Output& out, const PointData& data) {
  VtkPointWriter(out, data, "UnstructuredGrid").writeUnstructured();
}

void writePolyDataXml(text::Output& out, const PointData& data) {
  VtkPointWriter(out, data, "PolyData").writePolyData();
}

}  // namespace cutwater::detail
