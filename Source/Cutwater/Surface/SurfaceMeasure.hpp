#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>

namespace cutwater {

/// The area and the volume of a surface.
struct SurfaceMeasure {
  double area = 0;
  /// By the divergence theorem: positive where faces are counter-clockwise seen from outside.
  /// Meaningful for closed surfaces only.
  double volume = 0;

  bool operator==(const SurfaceMeasure&) const = default;
};

/// Measures `count` triangles. The volume is a sum of tetrahedra with an apex at `center`, which
/// should lie amid the triangles: far from the origin, terms would otherwise cancel. Sums are
/// formed in twice the precision; linear time.
[[nodiscard]] SurfaceMeasure measureTriangles(
    std::size_t count, const Vec3<double>& center,
    FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> cornersOf);

/// Measures the polygons as triangulate() cuts them.
[[nodiscard]] SurfaceMeasure measure(const PolygonSoup& soup);

}  // namespace cutwater
