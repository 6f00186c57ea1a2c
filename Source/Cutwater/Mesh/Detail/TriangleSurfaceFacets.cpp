#include <Cutwater/Mesh/Detail/TriangleSurfaceSDF.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>

// Access to the triangles of meshes.

namespace cutwater {

template <std::floating_point T>
bool TriangleSurfaceSDF<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  const auto q = scaled(box);
  if (!q) {  // too far away: the surface is a point
    return SignedDistanceFunction<T>::localFacetsIn(box, visit);
  }
  const QueryBox query(*q);
  constexpr double kTouching = std::numeric_limits<double>::min();
  around(*q, kTouching, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      if (query.isApart(query.toBox(surface_.corners(id)))) continue;
      if (!visit(facet(id, query))) return 0.0;  // nothing is nearer than that
    }
    return kTouching;
  });
  return true;
}

template <std::floating_point T>
SurfaceFacet<T> TriangleSurfaceSDF<T>::facet(std::uint32_t id, const QueryBox& box) const {
  const auto normalOf = [this](std::uint32_t triangle) {
    const auto [a, b, c] = surface_.corners(triangle);
    return Vec3<T>(normalized(cross(b - a, c - a)));
  };
  SurfaceFacet<T> result{triangle(id), normalOf(id), {}, surface_.owner(id)};
  const auto corners = surface_.corners(id);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto neighbour = surface_.neighbours[id][i];
    const auto& first = corners[i];
    const auto& second = corners[(i + 1) % 3];
    if (neighbour == kNone || box.isApart(box.toBox({first, second, second}))) continue;
    result.across[i] = normalOf(neighbour);
  }
  return result;
}

// The rest of the class is instantiated where it is defined.
#define CUTWATER_DEFINE(T)                                                                   \
  template bool TriangleSurfaceSDF<T>::localFacetsIn(const OrientedBox<T>&, FacetVisitor<T>) \
      const;                                                                                 \
  template SurfaceFacet<T> TriangleSurfaceSDF<T>::facet(std::uint32_t, const QueryBox&) const;
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE

}  // namespace cutwater
