#pragma once

#include <Cutwater/Surface/ReadSurface.hpp>

namespace cutwater {

/// Reads a surface as readSurface() does, or from VTK XML, PolyData (.vtp): see readPointData() for
/// what is read of that format. Polygons stay as they are, strips become triangles, and polygons
/// come first; vertices, lines and data are not kept. All faces belong to one patch, named after
/// the file.
/// @throws Error as readSurface() and readPointData().
[[nodiscard]] SurfaceFile readAnySurface(const std::filesystem::path& path,
                                         const ReadOptions& options = {});

}  // namespace cutwater
