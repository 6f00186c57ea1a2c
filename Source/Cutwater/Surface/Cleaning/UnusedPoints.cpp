#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

namespace cutwater {

Correction removeUnusedPoints(PolygonSoup& soup) {
  auto& points = soup.points;
  std::vector<std::uint32_t> newIndex(points.size(), kNone);
  for (const auto corner : soup.corners) newIndex[corner] = 0;
  Correction correction;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (newIndex[i] == kNone) correction.add(points[i]);
  }
  // Nothing below allocates: either all are removed, or the soup is unchanged.
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (newIndex[i] == kNone) continue;
    points[kept] = points[i];
    newIndex[i] = kept++;
  }
  points.resize(kept);
  for (auto& corner : soup.corners) corner = newIndex[corner];
  return correction;
}

}  // namespace cutwater
