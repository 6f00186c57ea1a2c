#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Text/LoadFile.hpp>
#include <Cutwater/Text/TextCursor.hpp>

#include <filesystem>
#include <initializer_list>
#include <vector>

namespace cutwater::detail {

/// The rows of a text table, optionally compressed by gzip, with fields separated by commas. Blanks
/// around fields, empty lines and lines that begin with # are ignored. Numbers are read in the C
/// locale.
class CsvRows {
 public:
  /// @throws Error(File) if the file cannot be read, Error(Limit) beyond `maxBytes`.
  CsvRows(const std::filesystem::path& path, std::uint64_t maxBytes);
  /// Of a file that has been read, and must outlive this.
  explicit CsvRows(const text::Content& content);

  /// Reads the next row. Returns false at the end of the file.
  bool next();
  [[nodiscard]] std::size_t fields() const { return fields_.size(); }
  [[nodiscard]] std::string_view text(std::size_t field) const { return fields_[field]; }
  /// @throws Error(File) with the line, unless it is a finite number.
  [[nodiscard]] double number(std::size_t field) const;
  /// The same, but infinity and NaN are numbers, too.
  [[nodiscard]] double numberOrNan(std::size_t field) const;
  [[nodiscard]] Vec3<double> point(std::size_t firstField) const {
    return {number(firstField), number(firstField + 1), number(firstField + 2)};
  }
  /// @throws Error(File) with the line, unless it is an index below `count`.
  [[nodiscard]] std::uint32_t index(std::size_t field, std::size_t count, const char* what) const;

  /// @throws Error(File) with the line, unless there are `count` fields.
  void requireFields(std::size_t count) const;
  /// Throw Error(File) with the line, or Error(Limit).
  [[noreturn]] void fail(const std::string& message) const { text_.fail(message); }
  [[noreturn]] void failLimit(const std::string& message) const { text_.failLimit(message); }

 private:
  text::Bytes bytes_;
  text::Content content_;
  text::TextCursor text_;
  std::vector<std::string_view> fields_;
};

}  // namespace cutwater::detail
