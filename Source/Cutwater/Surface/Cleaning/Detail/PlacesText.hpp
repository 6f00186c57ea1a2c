#pragma once

#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

namespace cutwater::detail {

/// The value with nine digits at most: for display, not for reading back.
[[nodiscard]] std::string shortText(double value);

/// " (1, 0, 0) (0, 0.5, 1)"; with an ellipsis where there are more than the examples.
[[nodiscard]] std::string placesText(const Findings<Vec3<double>>& places);

/// ", area 6 -> 5, volume 1 -> 0.8"; each only if it changed.
[[nodiscard]] std::string changeText(const SurfaceMeasure& before, const SurfaceMeasure& after);

}  // namespace cutwater::detail
