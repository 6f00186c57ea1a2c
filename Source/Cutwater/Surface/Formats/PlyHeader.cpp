#include <Cutwater/Surface/Formats/PlyHeader.hpp>

#include <array>
#include <utility>

namespace cutwater::formats {

namespace {

// More than any file needs; prevents a hostile header from taking more memory than disk space.
constexpr std::size_t kMostElements = 256;
constexpr std::size_t kMostProperties = 4096;

ScalarType scalarType(TextCursor& text) {
  constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kNames = {{
      {"char", ScalarType::Int8},
      {"int8", ScalarType::Int8},
      {"uchar", ScalarType::UInt8},
      {"uint8", ScalarType::UInt8},
      {"short", ScalarType::Int16},
      {"int16", ScalarType::Int16},
      {"ushort", ScalarType::UInt16},
      {"uint16", ScalarType::UInt16},
      {"int", ScalarType::Int32},
      {"int32", ScalarType::Int32},
      {"uint", ScalarType::UInt32},
      {"uint32", ScalarType::UInt32},
      {"float", ScalarType::Float32},
      {"float32", ScalarType::Float32},
      {"double", ScalarType::Float64},
      {"float64", ScalarType::Float64},
  }};
  const auto word = text.word();
  for (const auto& [name, type] : kNames) {
    if (word == name) return type;
  }
  text.fail("unknown number type " + inQuotes(word));
}

ScalarType integerType(TextCursor& text) {
  const ScalarType type = scalarType(text);
  if (!isInteger(type)) text.fail("a list needs an integer count");
  return type;
}

std::string_view name(TextCursor& text) {
  const auto word = text.word();
  if (word.empty()) text.fail("a name is missing");
  return word;
}

void readFormat(TextCursor& text, PlyHeader& header) {
  const auto encoding = text.word();
  header.ascii = encoding == "ascii";
  header.order = encoding == "binary_big_endian" ? std::endian::big : std::endian::little;
  if (!header.ascii && encoding != "binary_big_endian" && encoding != "binary_little_endian") {
    text.fail("unknown PLY encoding " + inQuotes(encoding));
  }
  const auto version = text.word();
  if (version != "1.0") text.fail("unknown PLY version " + inQuotes(version));
}

void readElement(TextCursor& text, PlyHeader& header) {
  auto& elements = header.elements;
  if (elements.size() >= kMostElements) text.fail("too many elements");
  const auto elementName = name(text);
  for (const auto& element : elements) {
    if (element.name == elementName) text.fail("a second element " + inQuotes(elementName));
  }
  const std::int64_t count = text.integer();
  if (count < 0) text.fail("the number of elements is " + std::to_string(count));
  elements.push_back({elementName, count, {}});
}

void readProperty(TextCursor& text, PlyHeader& header) {
  if (header.elements.empty()) text.fail("a property before any element");
  auto& properties = header.elements.back().properties;
  if (properties.size() >= kMostProperties) text.fail("an element of too many properties");
  PlyProperty property;
  TextCursor ahead = text;
  if (ahead.word() == "list") {
    text = ahead;
    property.listCount = integerType(text);
  }
  property.type = scalarType(text);
  property.name = name(text);
  properties.push_back(property);
}

}  // namespace

PlyHeader readPlyHeader(TextCursor& text) {
  PlyHeader header;
  bool formatKnown = false;
  if (!text.nextLine() || text.word() != "ply") text.fail("expected \"ply\"");
  text.requireLineEnd();
  while (text.nextLine()) {
    const auto keyword = text.word();
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") {
      if (!formatKnown) text.fail("the header has no format");
      return header;
    }
    if (keyword == "format") {
      readFormat(text, header);
      formatKnown = true;
    } else if (keyword == "element") {
      readElement(text, header);
    } else if (keyword == "property") {
      readProperty(text, header);
    } else {
      text.fail("unknown header line " + inQuotes(keyword));
    }
    text.requireLineEnd();
  }
  text.fail("the header has no end_header");
}

}  // namespace cutwater::formats
