#include <Cutwater/Surface/Detail/IndexTable.hpp>
#include <Cutwater/Surface/Detail/PointMerging.hpp>

namespace cutwater::detail {

std::vector<std::uint32_t> firstEqualPoints(std::span<const Vec3<double>> points) {
  std::vector<std::uint32_t> firsts(points.size());
  IndexTable table;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    firsts[i] = isFinite(points[i]) ? table.findOrInsert(
                                          i, [&](std::uint32_t j) { return hashOf(points[j]); },
                                          [&](std::uint32_t j) { return points[j] == points[i]; })
                                    : i;
  }
  return firsts;
}

std::size_t mergePoints(PolygonSoup& soup, std::span<std::uint32_t> firsts) {
  auto& points = soup.points;
  const std::size_t before = points.size();
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < before; ++i) {
    if (firsts[i] == i) {
      points[kept] = points[i];
      firsts[i] = kept++;
    } else {
      firsts[i] = firsts[firsts[i]];
    }
  }
  points.resize(kept);
  for (auto& corner : soup.corners) corner = firsts[corner];
  return before - kept;
}

}  // namespace cutwater::detail
