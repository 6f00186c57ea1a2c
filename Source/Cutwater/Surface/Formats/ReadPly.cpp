#include <Cutwater/Surface/Formats/PlyHeader.hpp>
#include <Cutwater/Surface/Formats/Readers.hpp>

#include <algorithm>
#include <array>

namespace cutwater::formats {

namespace {

// The numbers of an ASCII body: one line per element, ignoring blank lines.
class AsciiValues {
 public:
  explicit AsciiValues(const TextCursor& behindHeader) : text_(behindHeader) {}

  [[nodiscard]] static std::uint64_t smallest(ScalarType) { return 2; }  // "0 "
  void beginElement() {
    if (!text_.nextFilledLine()) text_.fail("the file ends too early");
  }
  void endElement() { text_.requireLineEnd(); }
  double number(ScalarType) { return text_.number(); }
  std::int64_t integer(ScalarType) { return text_.integer(); }
  void skip(ScalarType, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) static_cast<void>(text_.number());
  }
  void requireEnd() {
    if (text_.nextFilledLine()) text_.fail("more lines than the header promises");
  }
  [[nodiscard]] const Cursor& cursor() const { return text_; }

 private:
  TextCursor text_;
};

class BinaryValues {
 public:
  BinaryValues(const Content& content, std::endian order, std::uint64_t begin)
      : bytes_(content, order) {
    bytes_.seek(begin);
  }

  [[nodiscard]] static std::uint64_t smallest(ScalarType type) { return sizeOf(type); }
  void beginElement() { bytes_.beginRecord(); }
  void endElement() {}
  double number(ScalarType type) { return bytes_.number(type); }
  std::int64_t integer(ScalarType type) { return bytes_.integer(type); }
  void skip(ScalarType type, std::uint64_t count) { bytes_.skip(count * sizeOf(type)); }
  void requireEnd() { bytes_.requireOnlyPadding(); }
  [[nodiscard]] const Cursor& cursor() const { return bytes_; }

 private:
  ByteCursor bytes_;
};

// The body in either encoding.
template <typename Values>
class PlyBody {
 public:
  PlyBody(Values values, SoupBuilder& builder) : values_(std::move(values)), builder_(builder) {}

  SurfaceFile read(const PlyHeader& header) {
    for (const auto& element : header.elements) {
      const std::uint64_t count = boundedCount(element);
      if (element.name == "vertex") {
        readPoints(element, count);
      } else if (element.name == "face") {
        readFaces(element, count);
      } else {
        skipElements(element, count);
      }
    }
    values_.requireEnd();
    return std::move(builder_).finish(values_.cursor());
  }

 private:
  static bool isCorners(const PlyProperty& property) {
    const bool named = property.name == "vertex_indices" || property.name == "vertex_index";
    return named && property.listCount && isInteger(property.type);
  }

  // Elements without properties take no room in the file, and no time here.
  [[nodiscard]] std::uint64_t boundedCount(const PlyElement& element) const {
    std::uint64_t smallest = 0;
    for (const auto& property : element.properties) {
      smallest += Values::smallest(property.listCount.value_or(property.type));
      const bool corners = element.name == "face" && isCorners(property);
      if (corners) smallest += 3 * Values::smallest(property.type);
    }
    const std::string what = "elements " + inQuotes(element.name);
    const auto count = values_.cursor().requireRecords(element.count, smallest, what.c_str());
    return smallest > 0 ? count : 0;
  }

  void readPoints(const PlyElement& element, std::uint64_t count) {
    const auto axes = axisOfProperties(element);
    builder_.reservePoints(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      values_.beginElement();
      Vec3<double> point;
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const auto& property = element.properties[p];
        if (axes[p] >= 0) {
          point[axes[p]] = values_.number(property.type);
        } else {
          skipProperty(property);
        }
      }
      values_.endElement();
      builder_.addPoint(point, values_.cursor());
    }
  }

  // For each property: the index of its coordinate, or -1.
  [[nodiscard]] std::vector<int> axisOfProperties(const PlyElement& element) const {
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    std::vector<int> axes(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view name = kNames[static_cast<std::size_t>(axis)];
      axes[propertyIndex(element, [name](const PlyProperty& property) {
        return property.name == name && !property.listCount;
      })] = axis;
    }
    return axes;
  }

  template <typename Wanted>
  [[nodiscard]] std::size_t propertyIndex(const PlyElement& element, Wanted wanted) const {
    const auto& properties = element.properties;
    const auto found = std::find_if(properties.begin(), properties.end(), wanted);
    if (found == properties.end()) {
      values_.cursor().fail(element.name == "vertex" ? "the points need properties x, y and z"
                                                     : "the faces need a list vertex_indices");
    }
    return static_cast<std::size_t>(found - properties.begin());
  }

  void readFaces(const PlyElement& element, std::uint64_t count) {
    const std::size_t corners = propertyIndex(element, isCorners);
    builder_.reservePolygons(count, 3 * count);
    for (std::uint64_t i = 0; i < count; ++i) {
      values_.beginElement();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == corners) {
          readFace(element.properties[p]);
        } else {
          skipProperty(element.properties[p]);
        }
      }
      values_.endElement();
    }
  }

  void readFace(const PlyProperty& list) {
    const std::uint64_t corners = readListCount(list);
    for (std::uint64_t i = 0; i < corners; ++i) {
      builder_.addCorner(values_.integer(list.type), values_.cursor());
    }
    builder_.endPolygon(values_.cursor());
  }

  void skipElements(const PlyElement& element, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      values_.beginElement();
      for (const auto& property : element.properties) skipProperty(property);
      values_.endElement();
    }
  }

  void skipProperty(const PlyProperty& property) {
    values_.skip(property.type, property.listCount ? readListCount(property) : 1);
  }

  std::uint64_t readListCount(const PlyProperty& list) {
    const std::int64_t count = values_.integer(*list.listCount);
    return values_.cursor().requireRecords(count, Values::smallest(list.type), "list items");
  }

  Values values_;
  SoupBuilder& builder_;
};

}  // namespace

SurfaceFile readPly(const Content& content, SoupBuilder& builder) {
  TextCursor text(content);
  const PlyHeader header = readPlyHeader(text);
  builder.report().binary = !header.ascii;
  if (header.ascii) return PlyBody(AsciiValues(text), builder).read(header);
  BinaryValues values(content, header.order, text.nextLineBegin());
  return PlyBody(std::move(values), builder).read(header);
}

}  // namespace cutwater::formats
