#pragma once

#include <Cutwater/Surface/WriteSurface.hpp>

#include <string>
#include <vector>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// A surface as its file will hold it.
struct SurfaceOutput {
  PolygonSoup soup;
  std::size_t patches = 0;  ///< in the file; 1 where the format has none
  /// Names and digits that the format does not keep, and which ones do: a sentence each.
  std::vector<std::string> losses;
};

/// Adds a required option for the surface's file, as in "-o,--output", and --ascii.
void addSurfaceOutput(Command command, const std::string& names, std::string& output,
                      WriteOptions& options);

/// STL holds only triangles, so polygons are triangulated for it. Binary STL has single precision:
/// coordinates are rounded, and points that become equal are merged.
/// @throws Error for a coordinate beyond single precision in a binary STL, and if single precision
/// leaves no face.
[[nodiscard]] SurfaceOutput asWritten(const std::string& file, PolygonSoup soup,
                                      const WriteOptions& options);

/// "12 polygons, 8 points, 1 patch"
[[nodiscard]] std::string sizeOf(const SurfaceOutput& surface);

/// One line for each loss, to be printed after the line that tells what was written.
[[nodiscard]] std::string lossesOf(const SurfaceOutput& surface);

}  // namespace cutwater::tool
