#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Repair/Detail/NearestPatches.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>

#include <algorithm>

namespace cutwater::detail {

DistanceRange takeNearestPatches(PolygonSoup& soup, const PolygonSoup& original) {
  // Signs do not matter here, so skip the work for them.
  const MeshSDF<double> surface(original, {.signs = SignScheme::NearestFeature, .probes = 0});
  soup.patchNames = original.patchNames;
  std::vector<double> distances(soup.polygonCount() + soup.points.size());
  const std::span all(distances);
  parallelFor(soup.polygonCount(), {.grain = 1024}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto nearest = surface.closestPoint(middleOf(soup, i));
      soup.patches[i] = nearest.owner.patch;
      all[i] = nearest.distance;
    }
  });
  surface.signedDistances(soup.points, all.subspan(soup.polygonCount()));
  for (auto& distance : distances) distance = std::abs(distance);
  if (distances.empty()) return {};
  const auto [least, greatest] = std::ranges::minmax(distances);
  return {.least = least, .greatest = greatest};
}

}  // namespace cutwater::detail
