#pragma once

#include <string>

#include "Report/Format.hpp"

namespace cutwater::tool {

/// A report for people, section by section.
class Page {
 public:
  void section(const std::string& title) { text_ += (text_.empty() ? "" : "\n") + title + "\n"; }
  void line(const std::string& name, const std::string& value) {
    plain(leftAligned(name, 18) + "  " + value);
  }
  void plain(const std::string& text) { text_ += "  " + onOneLine(text) + "\n"; }
  /// Adds text, broken between words so that lines end before column 100. Lines after the first are
  /// indented.
  void wrapped(const std::string& head, const std::string& words);
  /// Adds lines that end with '\n', such as those of the library's reports.
  void lines(const std::string& text);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace cutwater::tool
