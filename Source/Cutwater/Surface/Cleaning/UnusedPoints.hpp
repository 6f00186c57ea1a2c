#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Removes the points that no polygon uses; the others keep their order. Linear time.
Correction removeUnusedPoints(PolygonSoup& soup);

}  // namespace cutwater
