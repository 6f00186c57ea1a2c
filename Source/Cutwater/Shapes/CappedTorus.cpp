#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Detail/RingConcavity.hpp>

#include <numbers>

namespace cutwater {

template <std::floating_point T>
CappedTorus<T>::CappedTorus(T major, T minor, T halfAngle) : major_(major), minor_(minor) {
  require(0 < minor && minor < major && std::isfinite(major),
          "CappedTorus: need 0 < minor < major < infinity", Named{"minor", minor},
          Named{"major", major});
  require(0 < halfAngle && halfAngle <= 180, "CappedTorus: need 0 < halfAngle <= 180 degrees",
          Named{"halfAngle", halfAngle});
  const double radians = static_cast<double>(halfAngle) * (std::numbers::pi / 180);
  toEnd_ = {static_cast<T>(std::cos(radians)), static_cast<T>(std::sin(radians))};
  if (halfAngle == 180) toEnd_ = {-1, 0};  // the whole ring
}

template <std::floating_point T>
bool CappedTorus<T>::isBeyondEnd(const Vec2<T>& q) const {
  return cross(toEnd_, q) > 0;
}

template <std::floating_point T>
T CappedTorus<T>::localSignedDistance(const Vec3<T>& p) const {
  const Vec2<T> q{p.x, std::abs(p.y)};
  if (isBeyondEnd(q)) {
    const auto gap = q - major_ * toEnd_;
    return length(Vec3<T>{gap.x, gap.y, p.z}) - minor_;
  }
  return length(Vec2<T>{length(q) - major_, p.z}) - minor_;
}

template <std::floating_point T>
Vec3<T> CappedTorus<T>::localGradient(const Vec3<T>& p) const {
  const Vec2<T> q{p.x, std::abs(p.y)};
  Vec2<T> gap;
  if (isBeyondEnd(q)) {
    if (q.y == 0) return {};  // both ends are equally near
    gap = q - major_ * toEnd_;
  } else {
    const T radius = length(q);
    if (!(radius > 0)) return {};  // much of the arc is equally near
    gap = ((radius - major_) / radius) * q;
  }
  return normalized(Vec3<T>{gap.x, p.y < 0 ? -gap.y : gap.y, p.z});
}

template <std::floating_point T>
std::optional<T> CappedTorus<T>::localConcavity(const OrientedBox<T>& box) const {
  const auto& p = box.center;
  // Where both ends are equally near, the distance has a ridge.
  const T reach = 2 * box.radius();
  if (p.x < reach && std::abs(p.y) < reach) return {};
  return detail::concavityAround(length(Vec2<T>{p.x, p.y}), box, localGuarantee());
}

template <std::floating_point T>
Guarantee<T> CappedTorus<T>::localGuarantee() const {
  auto guarantee = Guarantee<T>::exact(major_ + minor_);
  const bool endsOverlap = toEnd_.x < 0 && toEnd_.y > 0 && major_ * toEnd_.y < minor_;
  if (endsOverlap) guarantee.inside = Quality::LowerBound;
  return guarantee;
}

template <std::floating_point T>
Box<T> CappedTorus<T>::localBoundingBox() const {
  const T widest = toEnd_.x < 0 ? major_ : major_ * toEnd_.y;
  const Box<T> arc{{major_ * toEnd_.x, -widest, 0}, {major_, widest, 0}};
  return localGuarantee().grown(arc.grown(minor_));
}

template class CappedTorus<float>;
template class CappedTorus<double>;

}  // namespace cutwater
