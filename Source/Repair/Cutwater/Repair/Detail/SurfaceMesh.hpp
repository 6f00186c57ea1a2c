#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace cutwater::detail {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

inline std::vector<CgalPoint> cgalPoints(std::span<const Vec3<double>> positions) {
  std::vector<CgalPoint> points;
  points.reserve(positions.size());
  for (const auto& p : positions) points.emplace_back(p.x, p.y, p.z);
  return points;
}

/// The faces of a soup of triangles.
inline std::vector<std::array<std::size_t, 3>> cgalTriangles(const PolygonSoup& soup) {
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(soup.polygonCount());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    faces.push_back({corners[0], corners[1], corners[2]});
  }
  return faces;
}

/// The mesh as a soup, all in patch 0. Elements removed from the mesh are left out.
inline PolygonSoup soupOf(const CgalMesh& mesh) {
  PolygonSoup soup;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    number[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> corners{};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners.at(k++) = number[v];
    soup.addPolygon(corners);
  }
  return soup;
}

}  // namespace cutwater::detail
