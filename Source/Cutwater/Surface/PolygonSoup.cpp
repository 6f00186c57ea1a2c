#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Detail/PointMerging.hpp>

namespace cutwater {

void PolygonSoup::addPolygon(std::span<const std::uint32_t> polygonCorners, std::uint32_t patch) {
  corners.insert(corners.end(), polygonCorners.begin(), polygonCorners.end());
  offsets.push_back(corners.size());
  patches.push_back(patch);
}

Box<double> PolygonSoup::boundingBox() const {
  Box<double> box;
  for (const auto corner : corners) box.extend(points[corner]);
  return box;
}

void PolygonSoup::validate() const {
  constexpr std::uint64_t kMost = kNone - 1;
  require(points.size() <= kMost, "PolygonSoup: more points than 32-bit indices can name",
          Named{"points", points.size()});
  require(patches.size() <= kMost, "PolygonSoup: more polygons than 32-bit indices can name",
          Named{"polygons", patches.size()});
  require(offsets.size() == patches.size() + 1, "PolygonSoup: need one offset more than patch ids",
          Named{"offsets", offsets.size()}, Named{"patches", patches.size()});
  require(offsets.front() == 0 && offsets.back() == corners.size(),
          "PolygonSoup: offsets must go from 0 to the number of corners",
          Named{"corners", corners.size()});
  for (std::size_t i = 0; i < patches.size(); ++i) {
    // Not a difference: offsets that descend would wrap around.
    require(offsets[i] <= corners.size() && offsets[i] + 3 <= offsets[i + 1],
            "PolygonSoup: every polygon needs three corners", Named{"polygon", i});
  }
  for (const std::uint32_t corner : corners) {
    require(corner < points.size(), "PolygonSoup: a corner is not a point", Named{"corner", corner},
            Named{"points", points.size()});
  }
  for (const auto& point : points) {
    require(isFinite(point), "PolygonSoup: points must be finite", Named{"point", point});
  }
}

std::size_t weldExactly(PolygonSoup& soup) {
  require(soup.points.size() < kNone, "weldExactly: more points than 32-bit indices can name",
          Named{"points", soup.points.size()});
  auto firsts = detail::firstEqualPoints(soup.points);
  return detail::mergePoints(soup, firsts);
}

}  // namespace cutwater
