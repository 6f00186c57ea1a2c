#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace cutwater {

struct CutCells;
struct CutLeaves;

/// Numbers in the type that a file has them in.
using DataNumbers =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                 std::vector<double>>;

/// A named array of a file: a row of `components` numbers for each point or cell.
struct DataArray {
  std::string name;
  DataNumbers numbers;  ///< row after row
  std::size_t components = 1;

  bool operator==(const DataArray&) const = default;
};

/// Cells of a mesh: VTK's number of the kind of each (12: hexahedron), and its corners. Cell i has
/// the corners [offsets[i], offsets[i + 1]).
struct DataCells {
  std::vector<std::uint8_t> kinds = {};
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint64_t> corners = {};  ///< indices of points
  /// Faces of polyhedra (kind 42), as VTK writes them: for each such cell the number of its faces,
  /// and for each face the number of its corners and these.
  std::vector<std::uint64_t> faces = {};
  /// For each cell, where its faces end in `faces`; -1 for cells that are no polyhedra. Empty if
  /// there are none.
  std::vector<std::int64_t> faceEnds = {};

  /// The number of cells, and the corners of one of them: indices of points.
  [[nodiscard]] std::size_t count() const { return kinds.size(); }
  [[nodiscard]] std::span<const std::uint64_t> cell(std::size_t i) const {
    return std::span(corners).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  bool operator==(const DataCells&) const = default;
};

/// What the cells of a file are: there are none; vertices, lines, polygons and strips, in this
/// order; or cells of any kind.
enum class DataMesh : std::uint8_t { Points, PolyData, Unstructured };

/// Points with data, and perhaps a mesh on them.
struct PointData {
  DataMesh mesh = DataMesh::Points;
  std::vector<Vec3<double>> points = {};
  bool singlePrecision = false;  ///< the file has coordinates in single precision
  bool isBinary = false;         ///< and not as text
  std::vector<DataArray> pointArrays = {};
  DataCells cells = {};
  std::vector<DataArray> cellArrays = {};
  std::vector<DataArray> fieldArrays = {};  ///< that belong to neither, such as a time
  std::vector<std::string> notes = {};      ///< what was not kept, one sentence each
  /// What the numbers of patches in an array stand for: written to .vtu and .vtp as field data, an
  /// array of texts called "patch names"; other formats have no place for them. Not read.
  std::vector<std::string> patchNames = {};
};

/// Options of readPointData().
struct ReadPointDataOptions {
  /// Refuse files, and arrays, that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

/// Reads points with everything that the file says of them. The content decides the format, not the
/// name; all may be compressed by gzip.
///
/// - A text table, with fields separated by commas. If its first line has names, those of the
///   coordinates are x, y, z (in either case, in any place) or Points:0, Points:1, Points:2, as
///   ParaView writes them; the other columns become arrays of doubles. Without names, the first
///   three columns are the coordinates. Empty lines and those that begin with # are skipped.
/// - NumPy's .npy, versions 1 to 3: an array of shape (n, 3) in C order, of little-endian floats or
///   doubles.
/// - Legacy VTK up to version 5.1, ASCII and binary: POLYDATA and UNSTRUCTURED_GRID.
/// - VTK XML, PolyData (.vtp) and UnstructuredGrid (.vtu) in one piece: ASCII, base64 and appended
///   data, compressed by zlib or not, in either byte order.
///
/// Texts, tables of colours and the names of components are not kept; `notes` says so. Memory is at
/// most 16 times the size of the (decompressed) file.
///
/// @throws Error(File) "path: line 7: ..." or "path: byte 84: ..." (in the decompressed data) if
/// the content is malformed, a coordinate is not finite, a cell has a corner that is no point, or
/// two arrays of a kind have one name; Error(Limit) beyond maxBytes.
[[nodiscard]] PointData readPointData(const std::filesystem::path& path,
                                      const ReadPointDataOptions& options = {});

/// The same from memory; `name` replaces the path in messages.
[[nodiscard]] PointData readPointData(std::span<const std::byte> bytes, const std::string& name,
                                      const ReadPointDataOptions& options = {});

/// Writes the points with everything, in the format of the path's extension: .csv, .npy, .vtk
/// (binary), .vtu or .vtp (XML followed by the numbers in raw binary). An existing file is replaced
/// only once the new one is complete.
///
/// Tables have a column for each component: "u" becomes u_x, u_y and u_z if it has three, and u_0,
/// u_1, ... otherwise. NumPy's files have a structure for each point (numpy.load() returns
/// an array whose field names are "points" and those of the arrays).
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the extension is
/// none of these; if the data are not whole: an array whose length does not fit, names that are
/// empty or occur twice, cells with corners that are no points; and if the format has no place for
/// them: cells in tables and .npy, cells other than vertices, lines, polygons and strips in .vtp,
/// polyhedra in .vtk. Error(Limit) for more than 2^31 - 1 points or corners in .vtk.
void writePointData(const std::filesystem::path& path, const PointData& data);

/// Checks that writePointData() has a place for the data in a file of this name, before work is
/// done on them. @throws Error(Argument) and Error(Limit) as that does, except for data that are
/// not whole.
void requireWritable(const std::filesystem::path& path, const PointData& data);

/// Cut cells as a mesh for writePointData(): a polyhedron for each piece, bounded by the polygons
/// of its arcs and its wall, which face outwards. Neighbours share corners.
///
/// For each: "fraction" and "volume"; "wall_area" and "wall_vector", out of the fluid; "patch", the
/// one with most of the wall, -1 without wall; "pieces", their number in the cell; "cell", its
/// index along each axis.
/// With `wholeCells`, the box's cells that are all fluid follow, as hexahedra.
/// @throws Error(Argument) if there are pieces without polygons: see CutOptions.
[[nodiscard]] PointData cutCellMesh(const CutCells& cells, bool wholeCells = false);
/// The same of the leaves of an octree, which is that which was cut: "cell" is the index on the
/// leaf's level then, "leaf" its number and "level" its level. Edges of polyhedra meet edge by
/// edge, at leaves of other levels as well; hexahedra that follow have their eight corners alone.
/// @throws Error(Argument) if the octree has another number of leaves, too.
template <std::floating_point T>
[[nodiscard]] PointData cutCellMesh(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                                    bool wholeLeaves = false);
extern template PointData cutCellMesh(const CutLeaves&, const OctreeCells<float>&, bool);
extern template PointData cutCellMesh(const CutLeaves&, const OctreeCells<double>&, bool);

/// The mean of each cell's corners. This is the centroid of a simplex, a parallelepiped and other
/// symmetric cells; of a pyramid or a distorted cell it is not. NaN for a cell without corners.
[[nodiscard]] std::vector<Vec3<double>> cellCenters(const PointData& data);

}  // namespace cutwater
