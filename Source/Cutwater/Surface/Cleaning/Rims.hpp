#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <optional>

namespace cutwater {

/// A loop of edges around an opening of a surface.
struct Rim {
  std::vector<std::uint32_t> points;  ///< in order, opposite to the adjacent faces; all distinct
  Box<double> box;                    ///< of these
};

/// A plane perpendicular to an axis (0, 1, 2).
struct AxisPlane {
  int axis = 0;
  double at = 0;  ///< the coordinate along the axis

  bool operator==(const AxisPlane&) const = default;
};

/// Finds the openings of a surface, as loops that together run along every edge that faces pass
/// more often one way than the other. Rims follow from the orientation of faces: run clean() first.
/// A rim that touches itself at a point is split into several. n log n for n corners.
/// @throws Error(Argument) for a soup that does not pass PolygonSoup::validate().
[[nodiscard]] std::vector<Rim> findRims(const PolygonSoup& soup);

/// The plane perpendicular to an axis that has all points of the rim within `tolerance` (a length),
/// if there is one: half way between the farthest of them. If there are several, the one to which
/// they are nearest.
[[nodiscard]] std::optional<AxisPlane> planeOf(const Rim& rim, double tolerance = 0);

}  // namespace cutwater
