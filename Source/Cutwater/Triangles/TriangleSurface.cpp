#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

int firstVertex(TrianglePart part) {
  using enum TrianglePart;
  switch (part) {
    case VertexB:
    case EdgeBC:
      return 1;
    case VertexC:
    case EdgeCA:
      return 2;
    default:
      return 0;
  }
}

}  // namespace

template <std::floating_point T>
void TriangleSurface<T>::compete(const Vec3<T>& p, std::span<const std::uint32_t> ids,
                                 Nearest& best) const {
  for (const auto id : ids) {
    if (id == kNone) return;
    const T squared = triangleDistance(p, triangle(id)).distanceSquared;
    if (!(squared <= best.tie)) continue;
    const auto [a, b, c] = corners(id);
    best.offer(squared, id, orientation(a, b, c, Vec3<double>(p)));
  }
}

template <std::floating_point T>
Vec3<T> TriangleSurface<T>::pseudonormal(std::uint32_t id, TrianglePart part) const {
  const auto corner = static_cast<std::size_t>(firstVertex(part));
  switch (featureOf(part)) {
    case Feature::Vertex:
      return pseudonormals[triangles[id][corner]];
    case Feature::Edge:
      if (const auto across = neighbours[id][corner]; across != kNone) {
        return unitNormal(triangle(id)) + unitNormal(triangle(across));
      }
      [[fallthrough]];
    default:
      return unitNormal(triangle(id));
  }
}

template <std::floating_point T>
int TriangleSurface<T>::pseudonormalSide(const Vec3<T>& p, const Nearest& nearest) const {
  if (nearest.triangle == kNone) return 1;
  const auto t = triangle(nearest.triangle);
  const auto part = triangleDistance(p, t).part;
  if (part == TrianglePart::Face) return sideOfPlane(p, t) < 0 ? -1 : 1;
  // The base point is a vertex of the feature; for an edge, the nearer one. From any other point
  // more digits would cancel.
  const int first = firstVertex(part);
  Vec3<T> from = p - t.vertex(first);
  if (featureOf(part) == Feature::Edge) {
    const Vec3<T> other = p - t.vertex((first + 1) % 3);
    if (lengthSquared(other) < lengthSquared(from)) from = other;
  }
  return dot(pseudonormal(nearest.triangle, part), from) < 0 ? -1 : 1;
}

template <std::floating_point T>
SurfacePoint<T> TriangleSurface<T>::surfacePoint(const Vec3<T>& p, const Nearest& nearest) const {
  if (nearest.triangle == kNone) return {};
  const auto t = triangle(nearest.triangle);
  const auto part = triangleDistance(p, t).part;
  const auto weights = closestBarycentric(p, t, part);
  // Relative to the vertex of largest weight, so that a vertex is found exactly.
  const int base = weights.x >= weights.y && weights.x >= weights.z ? 0
                   : weights.y >= weights.z                         ? 1
                                                                    : 2;
  const Vec3<T> origin = t.vertex(base);
  const Vec3<T> point =
      origin + weights.x * (t.a - origin) + weights.y * (t.b - origin) + weights.z * (t.c - origin);
  SurfacePoint<T> result;
  result.point = point / scale;
  result.normal = normalized(pseudonormal(nearest.triangle, part));
  result.tolerance = 2 * error(p) / scale;  // of the distance, and of the point
  result.exact = true;
  result.feature = featureOf(part);
  result.owner = owner(nearest.triangle);
  result.triangle = nearest.triangle;
  result.barycentric = weights;
  return result;
}

template struct TriangleSurface<float>;
template struct TriangleSurface<double>;

}  // namespace cutwater
