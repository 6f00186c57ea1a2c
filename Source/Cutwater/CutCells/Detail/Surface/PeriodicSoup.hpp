#pragma once

#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater {

/// The period of a body of triangles, which starts where the fewest images matter.
/// @throws Error(Argument) as that of a box.
[[nodiscard]] CutPeriod periodOf(const PolygonSoup& body, const Vec3<double>& length);

/// The body and those of its images that matter where cells are cut, with rounded vertices, those
/// in one place merged. Vertices are in the order of their coordinates, and images in the order of
/// theirs: so images are alike, but for where they are.
[[nodiscard]] PolygonSoup withImages(const PolygonSoup& body, const CutPeriod& period);

/// Whether images may touch each other.
[[nodiscard]] bool imagesMayTouch(const PolygonSoup& body, const CutPeriod& period);

}  // namespace cutwater
