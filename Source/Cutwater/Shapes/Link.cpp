#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Shapes/Detail/RingConcavity.hpp>
#include <Cutwater/Shapes/Link.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Link<T>::Link(T length, T major, T minor) : half_(T(0.5) * length), major_(major), minor_(minor) {
  require(0 < minor && minor < major && std::isfinite(major),
          "Link: need 0 < minor < major < infinity", Named{"minor", minor}, Named{"major", major});
  require(0 <= length && std::isfinite(length), "Link: need 0 <= length < infinity",
          Named{"length", length});
}

template <std::floating_point T>
T Link<T>::localSignedDistance(const Vec3<T>& p) const {
  const Vec2<T> q{p.x, std::max(std::abs(p.y) - half_, T(0))};
  return length(Vec2<T>{length(q) - major_, p.z}) - minor_;
}

template <std::floating_point T>
Vec3<T> Link<T>::localGradient(const Vec3<T>& p) const {
  const Vec2<T> q{p.x, std::max(std::abs(p.y) - half_, T(0))};
  const T radius = length(q);
  if (!(radius > 0)) return {};  // both sides are equally near
  const auto gap = ((radius - major_) / radius) * q;
  return normalized(Vec3<T>{gap.x, p.y < 0 ? -gap.y : gap.y, p.z});
}

template <std::floating_point T>
std::optional<T> Link<T>::localConcavity(const OrientedBox<T>& box) const {
  // Between the ends, the rods are convex on either side of x = 0, where this is 0.
  const auto& p = box.center;
  const T toAxis = length(Vec2<T>{p.x, std::max(std::abs(p.y) - half_, T(0))});
  return detail::concavityAround(toAxis, box, localGuarantee());
}

template <std::floating_point T>
Guarantee<T> Link<T>::localGuarantee() const {
  return Guarantee<T>::exact(half_ + major_ + minor_);
}

template <std::floating_point T>
Box<T> Link<T>::localBoundingBox() const {
  const T reach = major_ + minor_;
  return localGuarantee().grown(
      {{-reach, -half_ - reach, -minor_}, {reach, half_ + reach, minor_}});
}

template class Link<float>;
template class Link<double>;

}  // namespace cutwater
