#pragma once

#include <Cutwater/Io/VtkFiles.hpp>

#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace cutwater {
class OutputFile;
}  // namespace cutwater

namespace cutwater::detail {

/// VTK's name for a type of numbers, such as "Float64".
template <typename Number>
constexpr std::string_view vtkType() {
  if constexpr (std::is_floating_point_v<Number>) {
    return sizeof(Number) == 4 ? "Float32" : "Float64";
  } else if constexpr (std::is_signed_v<Number>) {
    return sizeof(Number) == 4 ? "Int32" : "Int64";
  } else {
    static_assert(sizeof(Number) == 1 || sizeof(Number) >= 4);
    return sizeof(Number) == 1 ? "UInt8" : sizeof(Number) == 4 ? "UInt32" : "UInt64";
  }
}

/// Builds the part of a VTK file before the numbers, element by element: XML that gives the
/// position of each array in the bytes that follow.
///
/// Format: "VTK File Formats", section XML, https://docs.vtk.org; appended data with
/// encoding="raw": after an underscore, each array is stored as its number of bytes, a UInt64,
/// followed by the bytes. Texts are numbers, one for each byte, and a zero ends each text, as
/// vtkXMLWriter writes them.
class VtkXml {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

  /// `dataSet`: "ImageData".
  explicit VtkXml(std::string_view dataSet, Attributes attributes = {});

  void open(std::string_view element, Attributes attributes = {});
  void close(std::string_view element);
  void empty(std::string_view element, Attributes attributes = {});

  /// Declares an array. Arrays must be written in the order in which they are declared here.
  void array(std::string_view name, std::string_view type, int components, std::uint64_t bytes);
  /// The same for field data, which belong to neither points nor cells: they need their number.
  void fieldArray(std::string_view name, std::string_view type, int components,
                  std::uint64_t tuples, std::uint64_t bytes);
  /// Adds an element with arrays, of which viewers show the first one first.
  void arrays(std::string_view element, std::span<const VtkArray> arrays);

  /// Adds the names of patches as field data, an array of texts in the order of their indices, so
  /// that files with patches as numbers tell what these are called. Nothing without names.
  void patchNames(const std::vector<std::string>& names);
  /// The array alone, within an element of field data that has others, too.
  void patchNamesArray(const std::vector<std::string>& names);

  /// The same for arrays that are in other files: their types only.
  void declarations(std::string_view element, std::span<const VtkArray> arrays);
  void declaration(std::string_view name, std::string_view type, int components);

  /// Returns everything up to the first array's bytes.
  [[nodiscard]] std::string finished();
  /// Returns the whole text of a file without arrays of its own.
  [[nodiscard]] std::string finishedAlone();
  /// The text that follows the last array.
  static constexpr std::string_view kEnd = "\n  </AppendedData>\n</VTKFile>\n";

 private:
  /// Opens the element that selects the array to show first.
  void openArrays(std::string_view element, const VtkArray& first);
  void tag(std::string_view element, Attributes attributes, std::string_view end);
  void line(std::string_view text);

  std::string dataSet_;
  std::string text_;
  std::size_t depth_ = 1;
  std::uint64_t offset_ = 0;
};

/// @throws Error(Argument), beginning with `caller`, if there is no array, or names are empty or
/// occur twice.
void checkVtkNames(const std::string& caller, std::span<const VtkArray> arrays);
/// @throws Error(Argument), beginning with `caller`, unless there are arrays, all of `count`
/// values, with names that are neither empty nor occur twice.
void checkVtkArrays(const std::string& caller, std::span<const VtkArray> arrays, std::size_t count);

/// Writes the number of bytes that follow.
void writeVtkSize(OutputFile& file, std::uint64_t bytes);
void writeVtkArrays(OutputFile& file, std::span<const VtkArray> arrays);

}  // namespace cutwater::detail
