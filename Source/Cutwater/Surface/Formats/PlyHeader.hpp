#pragma once

#include <Cutwater/Surface/Formats/TextNames.hpp>

#include <optional>
#include <vector>

namespace cutwater::formats {

struct PlyProperty {
  std::string_view name;
  ScalarType type = ScalarType::Float32;  ///< of the value, or of a list's items
  std::optional<ScalarType> listCount;    ///< type of the count that precedes a list's items
};

struct PlyElement {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// What a PLY header states about the data behind it; names are views of the file.
struct PlyHeader {
  bool ascii = false;
  std::endian order = std::endian::little;
  std::vector<PlyElement> elements;
};

/// Reads up to and including the line "end_header".
[[nodiscard]] PlyHeader readPlyHeader(TextCursor& text);

}  // namespace cutwater::formats
