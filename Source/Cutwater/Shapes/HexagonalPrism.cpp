#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace cutwater {

namespace {

/// Reflected in the line through the origin and the corner at 60 degrees.
template <std::floating_point T>
Vec2<T> mirrored(const Vec2<T>& p) {
  constexpr T kSine = std::numbers::sqrt3_v<T> / 2;
  return {kSine * p.y - T(0.5) * p.x, kSine * p.x + T(0.5) * p.y};
}

}  // namespace

template <std::floating_point T>
HexagonalPrism<T>::HexagonalPrism(T inradius, T height)
    : Prismatic<T>("HexagonalPrism", T(-0.5) * height, T(0.5) * height),
      inradius_(inradius),
      halfSide_(inradius / std::numbers::sqrt3_v<T>) {
  require(0 < inradius && std::isfinite(inradius), "HexagonalPrism: need 0 < inradius < infinity",
          Named{"inradius", inradius});
}

template <std::floating_point T>
T HexagonalPrism<T>::sectionDistance(const Vec2<T>& p) const {
  const Vec2<T> quadrant{std::abs(p.x), std::abs(p.y)};
  const auto image = mirrored(quadrant);
  const auto q = image.y > quadrant.y ? image : quadrant;
  const T beyond = q.y - inradius_;
  if (beyond < 0) return beyond;
  return length(Vec2<T>{std::max(std::abs(q.x) - halfSide_, T(0)), beyond});
}

template <std::floating_point T>
Vec2<T> HexagonalPrism<T>::sectionGradient(const Vec2<T>& p) const {
  const Vec2<T> quadrant{std::abs(p.x), std::abs(p.y)};
  const auto image = mirrored(quadrant);
  const bool isMirrored = image.y > quadrant.y;
  const auto q = isMirrored ? image : quadrant;
  const T beyond = q.y - inradius_;
  Vec2<T> gradient{0, 1};
  if (beyond > 0) {
    gradient = normalized(Vec2<T>{q.x - std::clamp(q.x, -halfSide_, halfSide_), beyond});
  } else if (image.y == quadrant.y || (isMirrored && p.y == 0)) {
    return {};  // two sides are equally near
  }
  if (isMirrored) gradient = mirrored(gradient);
  return {p.x < 0 ? -gradient.x : gradient.x, p.y < 0 ? -gradient.y : gradient.y};
}

template <std::floating_point T>
bool HexagonalPrism<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  constexpr T kSine = std::numbers::sqrt3_v<T> / 2;
  const std::array<Vec3<T>, 3> across{{{0, 1, 0}, {kSine, T(0.5), 0}, {kSine, T(-0.5), 0}}};
  for (const auto& normal : across) {
    for (const T side : {inradius_, -inradius_}) detail::visitPlane(side * normal, normal, visit);
  }
  this->visitEnds(visit);
  return true;
}

template <std::floating_point T>
Guarantee<T> HexagonalPrism<T>::localGuarantee() const {
  return Guarantee<T>::exact(2 * halfSide_ + this->upper());
}

template <std::floating_point T>
Box<T> HexagonalPrism<T>::localBoundingBox() const {
  const Vec3<T> corner{2 * halfSide_, inradius_, this->upper()};
  return localGuarantee().grown({-corner, corner});
}

template class HexagonalPrism<float>;
template class HexagonalPrism<double>;

}  // namespace cutwater
