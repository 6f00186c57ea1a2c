#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/BoxDistance.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

#include <array>

namespace cutwater {

template <std::floating_point T>
Cylinder<T>::Cylinder(const Vec3<T>& a, const Vec3<T>& b, T radius)
    : Axisymmetric<T>("Cylinder", a, b - a),
      radius_(radius),
      length_(detail::distanceBetween(a, b)),
      size_(detail::farther(a, b) + radius),
      section_(detail::rectangle(radius, T(0), length_)) {
  require(radius > 0 && std::isfinite(radius), "Cylinder: need 0 < radius < infinity",
          Named{"radius", radius});
}

template <std::floating_point T>
T Cylinder<T>::profileDistance(const ProfilePoint<T>& p) const {
  return detail::boxDistance(section_, {p.radial, p.axial, 0});
}

template <std::floating_point T>
ProfilePoint<T> Cylinder<T>::profileGradient(const ProfilePoint<T>& p) const {
  const auto g = detail::boxGradient(section_, {p.radial, p.axial, 0});
  return {g.x, g.y};
}

template <std::floating_point T>
bool Cylinder<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  const std::array<ProfilePoint<T>, 4> corners{
      {{0, 0}, {radius_, 0}, {radius_, length_}, {0, length_}}};
  detail::visitRevolved<T>(this->rotationAxis(), corners, visit);
  return true;
}

template <std::floating_point T>
Guarantee<T> Cylinder<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> Cylinder<T>::localBoundingBox() const {
  return localGuarantee().grown(this->rotationAxis()
                                    .discBox(0, radius_)
                                    .extend(this->rotationAxis().discBox(length_, radius_)));
}

template class Cylinder<float>;
template class Cylinder<double>;

}  // namespace cutwater
