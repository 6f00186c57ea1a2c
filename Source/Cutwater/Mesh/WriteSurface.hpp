#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <filesystem>

namespace cutwater {

/// Options of writeSurface().
struct WriteOptions {
  /// STL, PLY and VTK as text; they are binary otherwise. OBJ and OFF are always text.
  bool ascii = false;
};

/// Writes STL, PLY, OBJ, OFF or legacy VTK, as the file name's extension says. The file appears
/// complete or not at all.
///
/// PLY and VTK (double), OBJ and OFF give the same coordinates when read back, to the bit: text has
/// the shortest digits that do, in every locale. ASCII STL too, but not which points were shared or
/// unused; binary STL holds single precision. OBJ and ASCII STL keep patches, as groups and solids;
/// VTK tells their indices, as an array of cell data that readSurface() does not look at; the
/// others have none.
///
/// @throws Error(Argument) for another extension, an invalid soup or a coordinate beyond single
/// precision in a binary STL; Error(Topology) for polygons in an STL that are no triangles;
/// Error(Limit) for more than the format can hold; Error(File) if the file cannot be written.
void writeSurface(const std::filesystem::path& path, const PolygonSoup& soup,
                  const WriteOptions& options = {});

}  // namespace cutwater
