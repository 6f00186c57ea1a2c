#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <map>

#include <gtest/gtest.h>

#include "Support/DamagedSoups.hpp"

namespace cutwater::test {

inline MeshReport reportOf(const PolygonSoup& soup) {
  return check(DcelMesh<double>(soup));
}

/// How often each edge between two positions is passed upward less downward, where that is not 0:
/// independent of how points are numbered and shared.
inline std::map<std::array<double, 6>, int> imbalances(const PolygonSoup& soup) {
  std::map<std::array<double, 6>, int> result;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& a = soup.points[corners[k]];
      const auto& b = soup.points[corners[(k + 1) % corners.size()]];
      const std::array up{a.x, a.y, a.z, b.x, b.y, b.z};
      const std::array down{b.x, b.y, b.z, a.x, a.y, a.z};
      if (up < down) ++result[up];
      if (down < up) --result[down];
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

inline bool sameSoup(const PolygonSoup& a, const PolygonSoup& b) {
  return a.points == b.points && a.corners == b.corners && a.offsets == b.offsets &&
         a.patches == b.patches && a.patchNames == b.patchNames;
}

/// The first triangles are cut in two at the middle of their first side; what lies beyond is not,
/// and a needle without area closes the crack.
inline PolygonSoup withNeedles(PolygonSoup soup, std::size_t needles) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    if (i >= needles) {
      result.addPolygon(c, soup.patches[i]);
      continue;
    }
    const auto middle = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(0.5 * (soup.points[c[0]] + soup.points[c[1]]));
    result.addPolygon(std::array{c[0], middle, c[2]}, soup.patches[i]);
    result.addPolygon(std::array{middle, c[1], c[2]}, soup.patches[i]);
    result.addPolygon(std::array{c[0], c[1], middle}, soup.patches[i]);
  }
  return result;
}

}  // namespace cutwater::test
