#pragma once

#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Text/ByteCursor.hpp>
#include <Cutwater/Text/Output.hpp>

// The formats of readPointData() and writePointData().
namespace cutwater::detail {

/// Each reads the whole content; all throw Error(File) with the line or byte.
[[nodiscard]] PointData readPointTable(const text::Content& content, std::uint64_t maxBytes);
[[nodiscard]] PointData readNpy(const text::Content& content, std::uint64_t maxBytes);
[[nodiscard]] PointData readLegacyVtk(const text::Content& content, std::uint64_t maxBytes);
/// Whether the content begins as XML does.
[[nodiscard]] bool isXml(std::string_view bytes);
[[nodiscard]] PointData readVtkXml(const text::Content& content, std::uint64_t maxBytes);

/// Each throws Error(Argument), beginning with `name`, for what its format has no place for.
void requireFitsTable(const PointData& data, const std::string& name);
void requireFitsNpy(const PointData& data, const std::string& name);
void requireFitsLegacyVtk(const PointData& data, const std::string& name);
void requireFitsUnstructuredXml(const PointData& data, const std::string& name);
void requireFitsPolyDataXml(const PointData& data, const std::string& name);

/// Each writes data that fit the format and are whole.
void writePointTable(text::Output& out, const PointData& data);
void writeNpy(text::Output& out, const PointData& data);
void writeLegacyVtk(text::Output& out, const PointData& data);
void writeUnstructuredXml(text::Output& out, const PointData& data);
void writePolyDataXml(text::Output& out, const PointData& data);

/// VTK's number of cells that are polyhedra.
inline constexpr std::uint8_t kVtkPolyhedron = 42;

/// What is wrong with the faces of polyhedra, as a message; empty if nothing is.
[[nodiscard]] std::string complaintAboutFaces(const DataCells& cells, std::size_t points);

/// @throws Error(Argument) unless the data are whole.
void checkPointData(const PointData& data);

/// `count` numbers of the type, 0.
[[nodiscard]] DataNumbers numbersOfType(text::ScalarType type, std::size_t count);
[[nodiscard]] text::ScalarType typeOf(const DataNumbers& numbers);
[[nodiscard]] std::size_t numberCount(const DataNumbers& numbers);

/// The names of an array's components in a table: u_x, u_y, u_z.
[[nodiscard]] std::vector<std::string> columnNames(const DataArray& array);

/// @throws Error(File) if the arrays have one of this name.
void requireNewName(const std::vector<DataArray>& arrays, std::string_view name,
                    const text::Cursor& at);

/// Collects the corners of cells, and finds those that are no points once these are counted.
class CornerCheck {
 public:
  /// Returns the index. @throws Error(File) if it is negative.
  std::uint64_t checked(std::int64_t index, const text::Cursor& at);
  /// @throws Error(File), with the place of the largest index, if it is not below `points`.
  void requireBelow(std::uint64_t points, const text::Cursor& at) const;

 private:
  std::uint64_t count_ = 0;  // the largest index, plus 1
  text::Place place_;
};

}  // namespace cutwater::detail
