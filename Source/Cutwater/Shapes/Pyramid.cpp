#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Pyramid<T>::Pyramid(T side, T height) : half_(T(0.5) * side), height_(height) {
  require(0 < side && std::isfinite(side), "Pyramid: need 0 < side < infinity",
          Named{"side", side});
  require(0 < height && std::isfinite(height), "Pyramid: need 0 < height < infinity",
          Named{"height", height});
  const auto rounded = [](double x, double y) {
    return Vec2<T>{static_cast<T>(x), static_cast<T>(y)};
  };
  const double a{half_};
  const double h{height};
  const double slant = std::hypot(a, h);
  normal_ = rounded(h / slant, a / slant);
  up_ = rounded(-a / slant, h / slant);
  const double edge = std::hypot(a, slant);
  edgeNormal_ = rounded(slant / edge, a / edge);
  edgeUp_ = rounded(-a / edge, slant / edge);
  edgeLength_ = static_cast<T>(edge);
}

template <std::floating_point T>
Vec3<T> Pyramid<T>::folded(const Vec3<T>& p) {
  const T x = std::abs(p.x);
  const T y = std::abs(p.y);
  return {std::max(x, y), std::min(x, y), p.z};
}

template <std::floating_point T>
T Pyramid<T>::flankDistance(const Vec3<T>& q) const {
  return dot(Vec2<T>{q.x - half_, q.z}, normal_);
}

template <std::floating_point T>
Vec3<T> Pyramid<T>::fromSurface(const Vec3<T>& q, T flank) const {
  // Below the base, or below the flank's lower edge in the flank's plane.
  const T up = dot(Vec2<T>{q.x - half_, q.z}, up_);
  if (q.z <= 0 || up <= 0) {
    const T x = q.z <= 0 ? std::min(q.x, half_) : half_;
    return {q.x - x, q.y - std::min(q.y, half_), q.z};
  }
  const Vec2<T> fromCorner{q.y - half_, up};
  const T beyond = dot(fromCorner, edgeNormal_);
  Vec2<T> inPlane{};
  if (beyond > 0) {
    const T along = dot(fromCorner, edgeUp_);
    inPlane = 0 < along && along < edgeLength_
                  ? beyond * edgeNormal_
                  : fromCorner - std::clamp(along, T(0), edgeLength_) * edgeUp_;
  }
  return {flank * normal_.x + inPlane.y * up_.x, inPlane.x, flank * normal_.y + inPlane.y * up_.y};
}

template <std::floating_point T>
T Pyramid<T>::localSignedDistance(const Vec3<T>& p) const {
  const auto q = folded(p);
  const T flank = flankDistance(q);
  const T deepest = std::max(flank, -q.z);
  return deepest < 0 ? deepest : length(fromSurface(q, flank));
}

template <std::floating_point T>
Vec3<T> Pyramid<T>::localGradient(const Vec3<T>& p) const {
  const auto q = folded(p);
  const T flank = flankDistance(q);
  const bool isFlankNearest = flank > -q.z;
  Vec3<T> gradient;
  if (std::max(flank, -q.z) > 0) {
    gradient = normalized(fromSurface(q, flank));
  } else if (flank == -q.z || (isFlankNearest && q.x == q.y)) {
    return {};  // two faces are equally near
  } else {
    gradient = isFlankNearest ? Vec3<T>{normal_.x, 0, normal_.y} : Vec3<T>{0, 0, -1};
  }
  if (std::abs(p.x) < std::abs(p.y)) std::swap(gradient.x, gradient.y);
  return {p.x < 0 ? -gradient.x : gradient.x, p.y < 0 ? -gradient.y : gradient.y, gradient.z};
}

template <std::floating_point T>
bool Pyramid<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  detail::visitPlane<T>({}, {0, 0, -1}, visit);
  for (const T side : {T(1), T(-1)}) {
    detail::visitPlane<T>({0, 0, height_}, {side * normal_.x, 0, normal_.y}, visit);
    detail::visitPlane<T>({0, 0, height_}, {0, side * normal_.x, normal_.y}, visit);
  }
  return true;
}

template <std::floating_point T>
Guarantee<T> Pyramid<T>::localGuarantee() const {
  return Guarantee<T>::exact(2 * half_ + height_);
}

template <std::floating_point T>
Box<T> Pyramid<T>::localBoundingBox() const {
  return localGuarantee().grown({{-half_, -half_, 0}, {half_, half_, height_}});
}

template class Pyramid<float>;
template class Pyramid<double>;

}  // namespace cutwater
