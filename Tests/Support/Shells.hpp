#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace cutwater::test {

/// All polygons of some soups, in one patch.
inline PolygonSoup joined(std::initializer_list<PolygonSoup> soups) {
  PolygonSoup result;
  for (const auto& soup : soups) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    result.points.insert(result.points.end(), soup.points.begin(), soup.points.end());
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      std::vector<std::uint32_t> corners;
      for (const auto corner : soup.polygon(i)) corners.push_back(first + corner);
      result.addPolygon(corners);
    }
  }
  return result;
}

/// Its signed volume, about its first point, and its area.
inline double volumeOf(const PolygonSoup& soup) {
  double sum = 0;
  const auto& origin = soup.points[soup.corners[0]];
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    for (std::size_t k = 2; k < p.size(); ++k) {
      sum += dot(soup.points[p[0]] - origin,
                 cross(soup.points[p[k - 1]] - origin, soup.points[p[k]] - origin)) /
             6;
    }
  }
  return sum;
}
inline double areaOf(const PolygonSoup& soup) {
  double sum = 0;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    Vec3<double> area;
    for (std::size_t k = 2; k < p.size(); ++k) {
      area += 0.5 * cross(soup.points[p[k - 1]] - soup.points[p[0]],
                          soup.points[p[k]] - soup.points[p[0]]);
    }
    sum += length(area);
  }
  return sum;
}

}  // namespace cutwater::test
