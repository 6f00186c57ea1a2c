#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/BoxDistance.hpp>
#include <Cutwater/Shapes/Detail/Prismatic.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

#include <string>

namespace cutwater {

template <std::floating_point T>
Prismatic<T>::Prismatic(const char* name, T lower, T upper)
    : ends_{{-Box<T>::kInf, lower, -Box<T>::kInf}, {0, upper, Box<T>::kInf}} {
  if (lower < upper && std::isfinite(lower) && std::isfinite(upper)) return;
  const std::string message = std::string(name) + ": need finite ends with lower < upper";
  require(false, message.c_str(), Named{"lower", lower}, Named{"upper", upper});
}

template <std::floating_point T>
T Prismatic<T>::localSignedDistance(const Vec3<T>& p) const {
  return detail::boxDistance(ends_, {sectionDistance({p.x, p.y}), p.z, 0});
}

template <std::floating_point T>
void Prismatic<T>::visitEnds(SurfaceVisitor<T> visit) const {
  detail::visitPlane<T>({0, 0, lower()}, {0, 0, -1}, visit);
  detail::visitPlane<T>({0, 0, upper()}, {0, 0, 1}, visit);
}

template <std::floating_point T>
Vec3<T> Prismatic<T>::localGradient(const Vec3<T>& p) const {
  const Vec2<T> q{p.x, p.y};
  const auto outer = detail::boxGradient(ends_, {sectionDistance(q), p.z, 0});
  if (outer.x == 0) return {0, 0, outer.y};
  const auto section = sectionGradient(q);
  if (section == Vec2<T>{}) return {};
  return {outer.x * section.x, outer.x * section.y, outer.y};
}

template class Prismatic<float>;
template class Prismatic<double>;

}  // namespace cutwater
