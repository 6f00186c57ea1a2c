#pragma once

#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

namespace cutwater::detail {

/// The mean of the polygon's corners.
[[nodiscard]] Vec3<double> middleOf(const PolygonSoup& soup, std::size_t polygon);

/// The diagonal of the polygon's box.
[[nodiscard]] double extentOf(const PolygonSoup& soup, std::size_t polygon);

/// Removes the polygons that are not to be kept. Allocates nothing.
void keepPolygons(PolygonSoup& soup, const std::vector<bool>& keep);

/// Reverses the polygon; its first corner stays the first.
void turnPolygon(PolygonSoup& soup, std::size_t polygon);

/// The corners' indices of triangulate()'s triangles.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> indicesOf(
    std::span<const TriangleCorners> triangles);

/// The edges that polygons pass more often one way than the other, see findOpenEdges(); `triangle`
/// is here the index of a polygon.
[[nodiscard]] std::vector<OpenEdge> openEdgesOf(const PolygonSoup& soup);

/// Per polygon: the part of the surface that it belongs to. Parts are connected across edges of any
/// kind.
[[nodiscard]] std::vector<std::uint32_t> partsOf(const PolygonSoup& soup);

/// Loops that together run along every open edge as often as it is open, opposite to the adjacent
/// faces; none passes a point twice. At every point, as many of the edges must begin as end.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> loopsAround(std::span<const OpenEdge> edges);

/// The id of the patch of this name; if there is none, the first id that has no name and no
/// polygons. Patches before it that have no name are called "surface" from then on.
[[nodiscard]] std::uint32_t patchNamed(PolygonSoup& soup, const std::string& name);

/// Rebuilds a soup polygon by polygon: `edit(i, corners, result)` adds what replaces the polygon to
/// `result`. Points, patches and order stay.
template <typename Edit>
PolygonSoup rebuilt(const PolygonSoup& soup, Edit edit) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  result.corners.reserve(soup.corners.size());
  result.offsets.reserve(soup.offsets.size());
  result.patches.reserve(soup.patches.size());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) edit(i, soup.polygon(i), result);
  return result;
}

}  // namespace cutwater::detail
