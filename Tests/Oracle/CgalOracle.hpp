#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <memory>
#include <vector>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "Support/TriangleOracle.hpp"

namespace cutwater::test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using AabbPrimitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, AabbPrimitive>>;

/// Where a point lies, without error.
enum class Side { Inside, On, Outside };

/// A surface of triangles as CGAL sees it: its AABB tree for the distance, its exact predicates for
/// the side.
class CgalOracle {
 public:
  explicit CgalOracle(const PolygonSoup& soup) {
    std::vector<Point> points;
    for (const auto& p : soup.points) points.emplace_back(p.x, p.y, p.z);
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto v = soup.polygon(i);
      if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) faces.push_back({v[0], v[1], v[2]});
    }
    CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(points, faces);
    // Splits points where the surface touches itself, so that any soup becomes a mesh.
    isManifold_ = CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, mesh_);
    tree_ = std::make_unique<AabbTree>(mesh_.faces().begin(), mesh_.faces().end(), mesh_);
    side_ = std::make_unique<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>>(*tree_);
  }

  /// Distance to the triangle that CGAL finds nearest, in quadruple precision.
  Float128 distance(const Vec3<double>& p) const {
    if (!isAccelerated_) isAccelerated_ = tree_->accelerate_distance_queries();
    const auto face = tree_->closest_point_and_primitive({p.x, p.y, p.z}).second;
    std::array<Vec3<double>, 3> corner;
    std::size_t i = 0;
    for (const auto v : CGAL::vertices_around_face(mesh_.halfedge(face), mesh_)) {
      const auto& q = mesh_.point(v);
      corner[i++] = {q.x(), q.y(), q.z()};
    }
    return triangleDistanceExactly(p, corner[0], corner[1], corner[2]);
  }
  /// By parity: what bounds a solid has no other.
  Side side(const Vec3<double>& p) const {
    const auto found = (*side_)({p.x, p.y, p.z});
    return found == CGAL::ON_BOUNDED_SIDE ? Side::Inside
           : found == CGAL::ON_BOUNDARY   ? Side::On
                                          : Side::Outside;
  }
  bool isInside(const Vec3<double>& p) const { return side(p) == Side::Inside; }
  /// Whether the box and the surface have a point in common.
  bool meets(const Box<double>& box) const {
    const auto& [a, b] = box;
    return tree_->do_intersect(Kernel::Iso_cuboid_3(Point(a.x, a.y, a.z), Point(b.x, b.y, b.z)));
  }

  /// Closed, free of self-intersections by exact tests, and every shell outward or a cavity, once
  /// all is turned as it has to be.
  bool boundsSolid() const {
    namespace Processing = CGAL::Polygon_mesh_processing;
    return isManifold_ && CGAL::is_closed(mesh_) && !Processing::does_self_intersect(mesh_) &&
           Processing::does_bound_a_volume(mesh_);
  }

 private:
  SurfaceMesh mesh_;
  bool isManifold_ = false;
  std::unique_ptr<AabbTree> tree_;
  mutable bool isAccelerated_ = false;
  std::unique_ptr<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>> side_;
};

/// The side by the definition, for closed oriented triangles that may touch and overlap: inside
/// where they wind around the point once or more. Counts all triangles that a segment to far away
/// passes, by exact tests; a segment that meets an edge or a vertex is replaced by another.
class WindingOracle {
 public:
  explicit WindingOracle(const PolygonSoup& soup) {
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      std::array<Point, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = soup.points[soup.polygon(i)[k]];
        triangle[k] = {p.x, p.y, p.z};
      }
      if (!CGAL::collinear(triangle[0], triangle[1], triangle[2])) triangles_.push_back(triangle);
    }
    const auto box = soup.boundingBox();
    middle_ = box.center();
    // Far, but not so far that all targets look alike from within rounding.
    reach_ = 8 * box.diagonal();
  }

  Side side(const Vec3<double>& p) const {
    const Point point(p.x, p.y, p.z);
    for (const auto& [a, b, c] : triangles_) {
      if (CGAL::orientation(a, b, c, point) != CGAL::COPLANAR) continue;
      if (Kernel::Triangle_3(a, b, c).has_on(point)) return Side::On;
    }
    for (int turn = 0;; ++turn) {
      int winding = 0;
      if (count(point, target(p, turn), winding)) {
        return winding >= 1 ? Side::Inside : Side::Outside;
      }
    }
  }

 private:
  Point target(const Vec3<double>& p, int turn) const {
    const double a = 1 + 2.4 * turn;  // any angles
    const double b = 0.3 + 1.7 * turn;
    const double reach = reach_ + 2 * length(p - middle_);
    return {middle_.x + reach * std::cos(a) * std::cos(b),
            middle_.y + reach * std::sin(a) * std::cos(b), middle_.z + reach * std::sin(b)};
  }
  /// Whether the segment meets no edge and no vertex.
  bool count(const Point& from, const Point& to, int& winding) const {
    for (const auto& [a, b, c] : triangles_) {
      const auto start = CGAL::orientation(a, b, c, from);
      const auto end = CGAL::orientation(a, b, c, to);
      if (start == end && start != CGAL::COPLANAR) continue;
      const std::array sides{CGAL::orientation(from, to, a, b), CGAL::orientation(from, to, b, c),
                             CGAL::orientation(from, to, c, a)};
      const bool left = std::ranges::count(sides, CGAL::POSITIVE) > 0;
      const bool right = std::ranges::count(sides, CGAL::NEGATIVE) > 0;
      if (left && right) continue;
      // In its line or plane without being on it, or through its border.
      if (start == CGAL::COPLANAR || end == CGAL::COPLANAR ||
          std::ranges::count(sides, CGAL::COPLANAR) > 0) {
        return false;
      }
      winding += end == CGAL::NEGATIVE ? -1 : 1;
    }
    return true;
  }

  std::vector<std::array<Point, 3>> triangles_;
  Vec3<double> middle_;
  double reach_ = 0;
};

}  // namespace cutwater::test
