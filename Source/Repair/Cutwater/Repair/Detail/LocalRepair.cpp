#include <Cutwater/Repair/Detail/CgalCall.hpp>
#include <Cutwater/Repair/Detail/LocalRepair.hpp>
#include <Cutwater/Repair/Detail/SurfaceMesh.hpp>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>

namespace cutwater::detail {
namespace {

namespace Processing = CGAL::Polygon_mesh_processing;

/// Visitor that CGAL queries before every part that it repairs.
class RepairWatch
    : public Processing::experimental::Remove_self_intersection_default_visitor<CgalMesh> {
 public:
  explicit RepairWatch(const Deadline& deadline) : deadline_(&deadline) {}
  [[nodiscard]] bool stop() const { return deadline_->isOver(); }

 private:
  const Deadline* deadline_;
};

}  // namespace

PolygonSoup withoutSelfIntersections(const PolygonSoup& triangles, int rounds,
                                     const Deadline& deadline) {
  const auto faces = cgalTriangles(triangles);
  if (!Processing::is_polygon_soup_a_polygon_mesh(faces)) {
    throw Error(ErrorKind::Topology,
                "removeSelfIntersections: the surface is not an oriented manifold");
  }
  CgalMesh mesh;
  callCgal("removeSelfIntersections", [&] {
    Processing::polygon_soup_to_polygon_mesh(cgalPoints(triangles.points), faces, mesh);
    Processing::experimental::remove_self_intersections(
        mesh, CGAL::parameters::number_of_iterations(rounds).preserve_genus(false).visitor(
                  RepairWatch(deadline)));
  });
  return soupOf(mesh);
}

}  // namespace cutwater::detail
