#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <filesystem>

namespace cutwater {

/// Options of writeSurface().
struct WriteOptions {
  /// Writes STL, PLY and VTK as text rather than binary. OBJ and OFF are always text.
  bool ascii = false;
};

/// Writes STL, PLY, OBJ, OFF or legacy VTK, depending on the file name's extension. The file
/// appears complete or not at all.
///
/// PLY and VTK (double), OBJ and OFF give the same coordinates when read back, to the bit: text has
/// the shortest digits that do so, in every locale. ASCII STL does, too, but does not record which
/// points were shared or unused; binary STL holds single precision. OBJ and ASCII STL keep patches,
/// as groups and solids, each once: the polygons are written patch by patch, in the order of
/// patchNames, and within a patch in their own. VTK keeps the indices of patches, as an array of
/// cell data that readSurface() ignores. The other formats have no patches.
///
/// @throws Error(Argument) for another extension, an invalid soup or a coordinate beyond single
/// precision in a binary STL; Error(Topology) for polygons other than triangles in an STL;
/// Error(Limit) for more than the format can hold; Error(File) if the file cannot be written.
void writeSurface(const std::filesystem::path& path, const PolygonSoup& soup,
                  const WriteOptions& options = {});

}  // namespace cutwater
