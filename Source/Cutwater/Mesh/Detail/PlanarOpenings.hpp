#pragma once

#include <Cutwater/Surface/Cleaning/Rims.hpp>

#include <span>

namespace cutwater::detail {

/// Openings in a plane across an axis.
struct PlanarOpenings {
  AxisPlane plane;
  Box<double> box;
  std::size_t rims = 0;
  std::size_t edges = 0;
  double spread = 0;  ///< largest distance of the rims' points from the plane
};

/// The planes across an axis in which rims lie within the tolerance (a length), those with the most
/// edges first. Planes within the tolerance of one another are one.
[[nodiscard]] std::vector<PlanarOpenings> planarOpenings(std::span<const Rim> rims,
                                                         double tolerance);

}  // namespace cutwater::detail
