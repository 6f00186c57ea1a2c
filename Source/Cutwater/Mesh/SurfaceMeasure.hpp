#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <array>

namespace cutwater {

/// How large a surface is.
struct SurfaceMeasure {
  double area = 0;
  /// By the divergence theorem: positive where faces are counter-clockwise seen from outside. Means
  /// something for closed surfaces only.
  double volume = 0;

  bool operator==(const SurfaceMeasure&) const = default;
};

/// Of `count` triangles. The volume is made of tetrahedra with a corner at `center`: one in their
/// midst, or they would cancel far from the origin. Summed in twice the precision; linear time.
[[nodiscard]] SurfaceMeasure measureTriangles(
    std::size_t count, const Vec3<double>& center,
    FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> cornersOf);

/// Of the polygons as triangulate() cuts them.
[[nodiscard]] SurfaceMeasure measure(const PolygonSoup& soup);

}  // namespace cutwater
