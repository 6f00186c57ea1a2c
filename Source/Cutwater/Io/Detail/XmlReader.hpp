#pragma once

#include <Cutwater/Text/Cursor.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cutwater::detail {

/// An element of an XML file, whose bytes it refers to.
struct XmlElement {
  std::string_view name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  /// What stands between its last child, or else its start tag, and its end tag: the bytes of the
  /// file, in which nothing is replaced.
  std::string_view text;
  std::uint64_t line = 0;      ///< of its start tag
  std::uint64_t textLine = 0;  ///< in which `text` begins

  /// The attribute's value, or nothing.
  [[nodiscard]] const std::string* attribute(std::string_view key) const;
  /// The first child of this name, or nothing.
  [[nodiscard]] const XmlElement* child(std::string_view key) const;
  [[nodiscard]] std::size_t count(std::string_view key) const;
};

/// Reads an XML file up to its end or, if there is an element `last`, up to the end of that one's
/// start tag: its text is the rest of the file, which need not be XML.
/// @throws Error(File) with the line, if the file is not well-formed, has a document type, more
/// than 4096 elements, or more than 32 within each other; or if the library was built without
/// expat.
[[nodiscard]] XmlElement readXml(const text::Content& content, std::string_view last);

/// @throws Error(File) "name: line 7: message".
[[noreturn]] void failAtLine(const text::Content& content, std::uint64_t line,
                             const std::string& message);

}  // namespace cutwater::detail
