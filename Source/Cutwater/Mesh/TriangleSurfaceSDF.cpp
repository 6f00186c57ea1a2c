#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/TriangleSurfaceSDF.hpp>

namespace cutwater {

template <std::floating_point T>
void TriangleSurfaceSDF<T>::setSurface(const Surface& surface, std::size_t turnedShells) {
  surface_ = surface;
  turnedShells_ = turnedShells;
  for (const auto& corners : surface.triangles) {
    for (const auto v : corners) box_.extend(surface.positions[v] / surface.scale);
  }
}

template <std::floating_point T>
std::array<Vec3<T>, 3> TriangleSurfaceSDF<T>::triangle(std::uint32_t id) const {
  require(id < triangleCount(), "triangle: no such triangle", Named{"id", id});
  const auto t = surface_.triangle(id);
  return {t.a / surface_.scale, t.b / surface_.scale, t.c / surface_.scale};
}

template <std::floating_point T>
T TriangleSurfaceSDF<T>::localSignedDistance(const Vec3<T>& point) const {
  const Vec3<T> p = surface_.scale * point;
  return surface_.signedDistance(p, nearest(p)) / surface_.scale;
}

template <std::floating_point T>
SurfacePoint<T> TriangleSurfaceSDF<T>::localClosestPoint(const Vec3<T>& point) const {
  const Vec3<T> p = surface_.scale * point;
  return surface_.surfacePoint(p, nearest(p));
}

template <std::floating_point T>
Vec3<T> TriangleSurfaceSDF<T>::localGradient(const Vec3<T>& point) const {
  const auto hit = localClosestPoint(point);
  const Vec3<T> away = hit.distance < 0 ? hit.point - point : point - hit.point;
  // On the surface the direction is lost to rounding: the pseudonormal is what it tends to.
  return std::abs(hit.distance) > 64 * hit.tolerance ? normalized(away) : hit.normal;
}

template <std::floating_point T>
SurfaceOwner TriangleSurfaceSDF<T>::localOwner(const Vec3<T>& point) const {
  return localClosestPoint(point).owner;
}

template <std::floating_point T>
Guarantee<T> TriangleSurfaceSDF<T>::localGuarantee() const {
  return Guarantee<T>::exact(surface_.size / surface_.scale);
}

template class TriangleSurfaceSDF<float>;
template class TriangleSurfaceSDF<double>;

}  // namespace cutwater
