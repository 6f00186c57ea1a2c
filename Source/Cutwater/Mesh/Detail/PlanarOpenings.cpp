#include <Cutwater/Mesh/Detail/PlanarOpenings.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

std::vector<PlanarOpenings> planarOpenings(std::span<const Rim> rims, double tolerance) {
  std::vector<PlanarOpenings> planes;
  for (const auto& rim : rims) {
    const auto plane = planeOf(rim, tolerance);
    if (!plane) continue;
    auto same = std::ranges::find_if(planes, [&](const PlanarOpenings& other) {
      return other.plane.axis == plane->axis && std::abs(other.plane.at - plane->at) <= tolerance;
    });
    if (same == planes.end()) same = planes.insert(planes.end(), {.plane = *plane, .box = {}});
    ++same->rims;
    same->box.extend(rim.box);
    same->edges += rim.points.size();
    for (const double side : {rim.box.lower[plane->axis], rim.box.upper[plane->axis]}) {
      same->spread = std::max(same->spread, std::abs(side - same->plane.at));
    }
  }
  std::ranges::stable_sort(planes, std::ranges::greater{}, &PlanarOpenings::edges);
  return planes;
}

}  // namespace cutwater::detail
