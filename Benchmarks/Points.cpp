#include "Points.hpp"

#include <algorithm>
#include <numeric>

namespace cutwater::benchmarks {

Vec3<double> Random::inBall(double radius) {
  const Box<double> cube{{-1, -1, -1}, {1, 1, 1}};
  auto p = in(cube);
  while (lengthSquared(p) > 1) p = in(cube);
  return radius * p;
}

Box<double> enlargedBox(const PolygonSoup& triangles) {
  const auto box = triangles.boundingBox();
  const auto margin = 0.125 * box.size();
  return {box.lower - margin, box.upper + margin};
}

std::vector<Vec3<double>> uniformPoints(const PolygonSoup& triangles, std::size_t count) {
  Random random(1);
  const auto box = enlargedBox(triangles);
  std::vector<Vec3<double>> points(count);
  for (auto& p : points) p = random.in(box);
  return points;
}

std::vector<Vec3<double>> narrowPoints(const PolygonSoup& triangles, std::size_t count) {
  std::vector<double> areasBefore{0};
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto v = triangles.polygon(i);
    const auto& a = triangles.points[v[0]];
    const auto normal = cross(triangles.points[v[1]] - a, triangles.points[v[2]] - a);
    areasBefore.push_back(areasBefore.back() + length(normal));
  }
  Random random(2);
  const double reach = 0.02 * triangles.boundingBox().diagonal();
  std::vector<Vec3<double>> points(count);
  for (auto& p : points) {
    const double area = random.unit() * areasBefore.back();
    const auto past = std::upper_bound(areasBefore.begin(), areasBefore.end(), area);
    const auto v = triangles.polygon(static_cast<std::size_t>(past - areasBefore.begin()) - 1);
    const double s = std::sqrt(random.unit());
    const double t = random.unit();
    p = (1 - s) * triangles.points[v[0]] + s * (1 - t) * triangles.points[v[1]] +
        s * t * triangles.points[v[2]] + random.inBall(reach);
  }
  return points;
}

std::vector<std::size_t> scattered(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(3);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

}  // namespace cutwater::benchmarks
