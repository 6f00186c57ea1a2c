#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <optional>

namespace cutwater {

/// A loop of edges around an opening of a surface.
struct Rim {
  std::vector<std::uint32_t> points;  ///< in order, against the faces beside it; none comes twice
  Box<double> box;                    ///< of these
};

/// A plane across an axis (0, 1, 2).
struct AxisPlane {
  int axis = 0;
  double at = 0;  ///< the coordinate along the axis

  bool operator==(const AxisPlane&) const = default;
};

/// The openings of a surface, by the loops that together run along every edge that faces pass more
/// often one way than the other. Rims follow from the orientation of faces: clean() first. One that
/// touches itself at a point comes as several. n log n for n corners.
/// @throws Error(Argument) for a soup that does not pass PolygonSoup::validate().
[[nodiscard]] std::vector<Rim> findRims(const PolygonSoup& soup);

/// The plane across an axis that all points of the rim are within `tolerance` (a length) of, if
/// there is one: half way between the farthest of them; of several the one they are nearest to.
[[nodiscard]] std::optional<AxisPlane> planeOf(const Rim& rim, double tolerance = 0);

}  // namespace cutwater
