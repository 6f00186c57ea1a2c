#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater {

template <std::floating_point T>
Octahedron<T>::Octahedron(T radius) : radius_(radius) {
  require(0 < radius && std::isfinite(radius), "Octahedron: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
T Octahedron<T>::reduction(const Vec3<T>& q) const {
  const T largest = maxComponent(q);
  const T smallest = -maxComponent(-q);
  const T ofFace = (q.x + q.y + q.z - radius_) / 3;
  if (ofFace <= smallest) return ofFace;
  const T middle = std::max(std::min(q.x, q.y), std::min(std::max(q.x, q.y), q.z));
  const T ofEdge = T(0.5) * (largest + middle - radius_);
  return ofEdge <= middle ? ofEdge : largest - radius_;
}

template <std::floating_point T>
T Octahedron<T>::localSignedDistance(const Vec3<T>& p) const {
  const Vec3<T> q = abs(p);
  const T t = reduction(q);
  if (t < 0) return std::numbers::sqrt3_v<T> * t;
  return length(min(q, Vec3<T>{t, t, t}));
}

template <std::floating_point T>
Vec3<T> Octahedron<T>::localGradient(const Vec3<T>& p) const {
  const Vec3<T> q = abs(p);
  const T t = reduction(q);
  Vec3<T> gradient{1, 1, 1};  // across a face, as long as t is below all q
  if (t > 0) gradient = min(q, Vec3<T>{t, t, t});
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] == 0 && gradient[axis] != 0) return {};  // faces on both sides are equally near
    if (p[axis] < 0) gradient[axis] = -gradient[axis];
  }
  return normalized(gradient);
}

template <std::floating_point T>
bool Octahedron<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  const auto cube = Box<T>{{-1, -1, -1}, {1, 1, 1}};
  for (int corner = 0; corner < 8; ++corner) {
    const auto normal = cube.corner(corner);
    detail::visitPlane<T>({normal.x * radius_, 0, 0}, normal, visit);
  }
  return true;
}

template <std::floating_point T>
Guarantee<T> Octahedron<T>::localGuarantee() const {
  return Guarantee<T>::exact(radius_);
}

template <std::floating_point T>
Box<T> Octahedron<T>::localBoundingBox() const {
  return localGuarantee().grown(Box<T>{{0, 0, 0}, {0, 0, 0}}.grown(radius_));
}

template class Octahedron<float>;
template class Octahedron<double>;

}  // namespace cutwater
