#include <Cutwater/Io/Detail/VtkXmlNumbers.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

// VTK XML, PolyData and UnstructuredGrid. ("VTK File Formats", section XML, https://docs.vtk.org.)

namespace cutwater::detail {

namespace {

using text::inQuotes;
using text::ScalarType;

class VtkXmlReader {
 public:
  VtkXmlReader(const text::Content& content, std::uint64_t maxBytes)
      : root_(readXml(content, "AppendedData")), numbers_(content, root_, maxBytes) {}

  PointData read() {
    const auto& dataSet = theDataSet();
    const auto& piece = only(dataSet, "Piece");
    const auto points = countOf(piece, "NumberOfPoints");
    readPoints(piece, points);
    if (data_.mesh == DataMesh::Unstructured) {
      readCells(piece, countOf(piece, "NumberOfCells"));
    } else {
      readParts(piece);
    }
    readArrays(piece.child("PointData"), points, data_.pointArrays);
    readArrays(piece.child("CellData"), data_.cells.count(), data_.cellArrays);
    for (const auto* const element : {root_.child("FieldData"), dataSet.child("FieldData")}) {
      readArrays(element, {}, data_.fieldArrays);
    }
    return std::move(data_);
  }

 private:
  const XmlElement& theDataSet() {
    if (root_.name != "VTKFile")
      numbers_.fail(root_, "expected VTKFile, found " + inQuotes(root_.name));
    const auto* const type = root_.attribute("type");
    const std::string name = type == nullptr ? "" : *type;
    if (name != "PolyData" && name != "UnstructuredGrid") {
      numbers_.fail(root_, "expected PolyData or UnstructuredGrid, found " + inQuotes(name));
    }
    data_.mesh = name == "PolyData" ? DataMesh::PolyData : DataMesh::Unstructured;
    return only(root_, name);
  }

  const XmlElement& only(const XmlElement& parent, const std::string& name) const {
    const auto count = parent.count(name);
    if (count == 1) return *parent.child(name);
    numbers_.fail(parent, "need one element " + name + ", found " + std::to_string(count));
  }

  [[nodiscard]] std::uint64_t countOf(const XmlElement& element, const std::string& name) const {
    const auto* const text = element.attribute(name);
    if (text == nullptr) numbers_.fail(element, "the attribute " + name + " is missing");
    std::uint64_t count = 0;
    const char* const end = text->data() + text->size();
    const auto parsed = std::from_chars(text->data(), end, count);
    if (parsed.ec == std::errc{} && parsed.ptr == end && count <= kMostCount) return count;
    numbers_.fail(element, name + " is " + inQuotes(*text));
  }

  void readPoints(const XmlElement& piece, std::uint64_t count) {
    const auto* const points = piece.child("Points");
    if (count == 0 && (points == nullptr || points->count("DataArray") == 0)) return;
    const auto& array = only(only(piece, "Points"), "DataArray");
    if (componentsOf(array) != 3) numbers_.fail(array, "points need 3 components");
    const auto type = numbers_.typeOfArray(array);
    data_.singlePrecision = type == ScalarType::Float32;
    data_.isBinary = array.attribute("format") == nullptr || *array.attribute("format") != "ascii";
    if (text::isInteger(type)) numbers_.fail(array, "points need floating-point numbers");
    const auto numbers = numbers_.read(array, 3 * count);
    data_.points.resize(count);
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
              data_.points[i][static_cast<int>(axis)] = static_cast<double>(values[3 * i + axis]);
            }
            if (isFinite(data_.points[i])) continue;
            numbers_.fail(array, "a coordinate of point " + std::to_string(i) + " is not finite");
          }
        },
        numbers);
  }

  [[nodiscard]] std::uint64_t componentsOf(const XmlElement& array) const {
    if (array.attribute("NumberOfComponents") == nullptr) return 1;
    const auto count = countOf(array, "NumberOfComponents");
    if (count == 0) numbers_.fail(array, "an array of 0 components");
    return count;
  }

  /// The array of a name among the children.
  const XmlElement* named(const XmlElement& parent, std::string_view name) const {
    const XmlElement* found = nullptr;
    for (const auto& child : parent.children) {
      const auto* const own = child.attribute("Name");
      if (child.name != "DataArray" || own == nullptr || *own != name) continue;
      if (found != nullptr) numbers_.fail(child, "a second array named " + inQuotes(name));
      found = &child;
    }
    return found;
  }
  const XmlElement& needed(const XmlElement& parent, std::string_view name) const {
    const auto* const found = named(parent, name);
    if (found == nullptr) numbers_.fail(parent, "there is no array named " + inQuotes(name));
    return *found;
  }

  /// Whole numbers, each at least `least`.
  template <typename Index>
  std::vector<Index> integers(const XmlElement& array, std::uint64_t count, Index least) {
    if (!text::isInteger(numbers_.typeOfArray(array))) numbers_.fail(array, "need whole numbers");
    const auto numbers = numbers_.read(array, count);
    std::vector<Index> result(count);
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = 0; i < count; ++i) {
            if constexpr (!std::is_floating_point_v<std::remove_cvref_t<decltype(values[0])>>) {
              if (!std::in_range<Index>(values[i]) || std::cmp_less(values[i], least)) {
                numbers_.fail(array, std::to_string(values[i]) + " is out of range");
              }
              result[i] = static_cast<Index>(values[i]);  // NOLINT(bugprone-signed-char-misuse)
            }
          }
        },
        numbers);
    return result;
  }

  /// Appends cells by their corners and by where those of each end; `kind` gives that of the i-th.
  template <typename Kind>
  void addCells(const XmlElement& element, std::uint64_t count, const Kind& kind) {
    auto& [kinds, offsets, corners, faces, faceEnds] = data_.cells;
    const auto& ends = needed(element, "offsets");
    const auto before = corners.size();
    for (const auto end : integers<std::uint64_t>(ends, count, 0)) {
      if (end > kMostCount || before + end < offsets.back()) {
        numbers_.fail(ends, "the offsets of cells must ascend");
      }
      offsets.push_back(before + end);
    }
    const auto& array = needed(element, "connectivity");
    for (const auto corner : integers<std::uint64_t>(array, offsets.back() - before, 0)) {
      if (corner >= data_.points.size()) {
        numbers_.fail(array, "index " + std::to_string(corner) + " is out of range: the file has " +
                                 std::to_string(data_.points.size()) + " points");
      }
      corners.push_back(corner);
    }
    for (std::size_t i = 0; i < count; ++i) kinds.push_back(kind(i));
  }

  /// Vertices, lines, polygons and strips: the order in which cell data belong to them.
  void readParts(const XmlElement& piece) {
    struct Part {
      const char* element;
      const char* count;
      std::uint8_t kind;
    };
    constexpr std::array<Part, 4> kParts{{{"Verts", "NumberOfVerts", 2},
                                          {"Lines", "NumberOfLines", 4},
                                          {"Polys", "NumberOfPolys", 7},
                                          {"Strips", "NumberOfStrips", 6}}};
    for (const auto& part : kParts) {
      if (piece.attribute(part.count) == nullptr) continue;
      const auto count = countOf(piece, part.count);
      if (count == 0) continue;
      addCells(only(piece, part.element), count, [&](std::size_t) { return part.kind; });
    }
  }

  void readCells(const XmlElement& piece, std::uint64_t count) {
    if (count == 0) return;
    const auto& cells = only(piece, "Cells");
    const auto kinds = integers<std::uint8_t>(needed(cells, "types"), count, 0);
    addCells(cells, count, [&](std::size_t i) { return kinds[i]; });
    if (std::ranges::count(kinds, kVtkPolyhedron) == 0) {
      if (const auto* const none = named(cells, "faces"))
        static_cast<void>(numbers_.read(*none, 0));
      return;
    }
    data_.cells.faceEnds = integers<std::int64_t>(needed(cells, "faceoffsets"), count, -1);
    const auto last = std::ranges::max(data_.cells.faceEnds);
    const auto& faces = needed(cells, "faces");
    data_.cells.faces = integers<std::uint64_t>(
        faces, static_cast<std::uint64_t>(std::max<std::int64_t>(last, 0)), 0);
    const auto complaint = complaintAboutFaces(data_.cells, data_.points.size());
    if (!complaint.empty()) numbers_.fail(faces, complaint);
  }

  /// Arrays with so many rows, or each with its own number of them.
  void readArrays(const XmlElement* element, std::optional<std::uint64_t> rows,
                  std::vector<DataArray>& arrays) {
    if (element == nullptr) return;
    for (const auto& array : element->children) {
      if (array.name != "DataArray" && array.name != "Array") continue;
      const auto* const name = array.attribute("Name");
      if (name == nullptr || name->empty()) numbers_.fail(array, "an array without a name");
      const auto* const type = array.attribute("type");
      if (type != nullptr && *type == "String") {
        data_.notes.push_back("The array " + inQuotes(*name) + " is text, and not kept.");
        continue;
      }
      for (const auto& other : arrays) {
        if (other.name == *name) numbers_.fail(array, "a second array named " + inQuotes(*name));
      }
      const auto components = componentsOf(array);
      const auto count = rows ? *rows : countOf(array, "NumberOfTuples");
      if (count > kMostCount / components)
        numbers_.fail(array, "more numbers than a file can have");
      arrays.push_back({*name, numbers_.read(array, components * count), components});
    }
  }

  /// More than any file has, and small enough for sums and for the bytes of three.
  static constexpr std::uint64_t kMostCount = std::uint64_t{1} << 47U;

  XmlElement root_;
  VtkXmlNumbers numbers_;
  PointData data_;
};

}  // namespace

PointData readVtkXml(const text::Content& content, std::uint64_t maxBytes) {
  return VtkXmlReader(content, maxBytes).read();
}

}  // namespace cutwater::detail
