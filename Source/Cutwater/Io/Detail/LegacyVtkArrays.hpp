#pragma once

#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/VtkCursor.hpp>

namespace cutwater::detail {

/// Reads the arrays of a legacy VTK file into point data.
class LegacyVtkArrays {
 public:
  LegacyVtkArrays(text::VtkCursor& file, PointData& data) : file_(file), data_(data) {}

  /// Begins a section of arrays with so many rows, such as POINT_DATA; reads their number.
  void begin(std::vector<DataArray>& arrays, std::size_t rows);
  /// Reads what follows a keyword, such as SCALARS. Returns whether it is one of arrays.
  bool read(std::string_view keyword);

 private:
  static bool is(std::string_view word, std::string_view keyword) {
    return text::VtkCursor::is(word, keyword);
  }
  text::TextCursor& text() { return file_.text(); }

  std::uint64_t components(std::string_view word);
  void readScalars(std::string_view name);
  void skipColours();
  void readFields();
  void readArray(std::string_view name, text::ScalarType type, std::uint64_t components);
  void addArray(std::vector<DataArray>& arrays, const text::VtkCursor::Field& field);
  template <typename Number>
  void readNumbers(std::vector<Number>& values, text::ScalarType type);

  text::VtkCursor& file_;
  PointData& data_;
  // Those that attributes belong to, and how many rows they must have.
  std::vector<DataArray>* arrays_ = nullptr;
  std::uint64_t rows_ = 0;
};

}  // namespace cutwater::detail
