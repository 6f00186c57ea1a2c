#include <Cutwater/Repair/Detail/CgalCall.hpp>
#include <Cutwater/Repair/Detail/RimFilling.hpp>
#include <Cutwater/Repair/Detail/SurfaceMesh.hpp>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

namespace cutwater::detail {
namespace {

/// Visitor that CGAL calls as it proceeds; throws when the time is up.
struct Watch : CGAL::Polygon_mesh_processing::Hole_filling::Default_visitor {
  const Deadline* deadline;

  explicit Watch(const Deadline& until) : deadline(&until) {}
  void quadratic_step() const { deadline->check(); }
  void cubic_step() const { deadline->check(); }
};

/// CGAL constructs a triangle from three ints.
struct Triple {
  std::array<std::uint32_t, 3> places;
  Triple(int a, int b, int c)
      : places{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(c)} {}
};

/// Whether the triangle contains the edge from index 0 to index 1 in this direction.
bool runsAlong(const std::array<std::uint32_t, 3>& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == 0 && t[(k + 1) % 3] == 1) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> fillRim(std::span<const Vec3<double>> rim,
                                                  std::span<const Vec3<double>> third,
                                                  const Deadline& deadline) {
  namespace Processing = CGAL::Polygon_mesh_processing;
  std::vector<Triple> triples;
  callCgal("fillHoles", [&] {
    const Watch watch(deadline);
    Processing::triangulate_hole_polyline(cgalPoints(rim), cgalPoints(third),
                                          std::back_inserter(triples),
                                          CGAL::parameters::visitor(std::cref(watch)));
  });
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool along = false;
  for (const auto& triple : triples) {
    triangles.push_back(triple.places);
    along = along || runsAlong(triple.places);
  }
  if (!along) {
    for (auto& [a, b, c] : triangles) std::swap(b, c);
  }
  return triangles;
}

}  // namespace cutwater::detail
