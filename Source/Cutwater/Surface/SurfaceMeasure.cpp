#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

namespace cutwater {

SurfaceMeasure measureTriangles(std::size_t count, const Vec3<double>& center,
                                FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> cornersOf) {
  DoubleDouble area;
  DoubleDouble sixVolumes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto corners = cornersOf(i);
    const auto& [a, b, c] = corners;
    area += polygonArea(corners).area;
    sixVolumes += dot(a - center, cross(b - a, c - a));
  }
  return {static_cast<double>(area), static_cast<double>(sixVolumes) / 6};
}

SurfaceMeasure measure(const PolygonSoup& soup) {
  const auto triangles = triangulate(soup).triangles;
  return measureTriangles(triangles.size(), soup.boundingBox().center(), [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i];
    return std::array{soup.points[index(a)], soup.points[index(b)], soup.points[index(c)]};
  });
}

}  // namespace cutwater
