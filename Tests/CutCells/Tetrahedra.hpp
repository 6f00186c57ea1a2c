#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <cstdint>
#include <utility>

#include "Support/Shells.hpp"

namespace cutwater::test {

/// A tetrahedron between points in any order, with its normals outwards.
inline PolygonSoup tetrahedronOf(std::array<Vec3<double>, 4> p) {
  if (dot(p[3] - p[0], cross(p[1] - p[0], p[2] - p[0])) < 0) std::swap(p[0], p[1]);
  PolygonSoup soup;
  soup.points.assign(p.begin(), p.end());
  using Triangle = std::array<std::uint32_t, 3>;
  for (const auto& triangle : {Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    soup.addPolygon(triangle);
  }
  return soup;
}

/// So many, between points that `next` makes.
template <typename Next>
PolygonSoup tetrahedraOf(int count, const Next& next) {
  PolygonSoup soup;
  for (int n = 0; n < count; ++n) {
    std::array<Vec3<double>, 4> points;
    for (auto& p : points) p = next();
    soup = joined({soup, tetrahedronOf(points)});
  }
  return soup;
}

}  // namespace cutwater::test
