#include <Cutwater/Core/Detail/DomainUnder.hpp>
#include <Cutwater/Operations/Detail/Fold.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/Plane.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Fold<T>::Fold(Solid<T> operand, const Vec3<T>& point, const Vec3<T>& normal)
    : PointMap<T>(std::move(operand)), plane_("folded", point, normal) {}

template <std::floating_point T>
Vec3<T> Fold<T>::mapped(const Vec3<T>& p) const {
  return plane_.height(p) < 0 ? plane_.image(p) : p;
}

template <std::floating_point T>
int Fold<T>::sideOf(const OrientedBox<T>& box) const {
  T reach = 0;
  for (const auto& half : box.halfAxis) reach += std::abs(dot(half, plane_.normal()));
  const T height = plane_.height(box.center);
  const T size = length(box.center) + box.radius() + length(plane_.point());
  const T margin = reach + box.slack + 16 * std::numeric_limits<T>::epsilon() * size;
  return height > margin ? 1 : height < -margin ? -1 : 0;
}

template <std::floating_point T>
T Fold<T>::leastHeight(const Box<T>& box) const {
  T least = Box<T>::kInf;
  for (int i = 0; i < 8; ++i) least = std::min(least, plane_.height(box.corner(i)));
  return least;
}

template <std::floating_point T>
OrientedBox<T> Fold<T>::mapped(const OrientedBox<T>& box) const {
  const int side = sideOf(box);
  if (side > 0) return box;
  const auto image = plane_.image(box);
  if (side < 0) return image;
  return OrientedBox<T>::of(box.bounds().extend(image.bounds()));
}

template <std::floating_point T>
Vec3<T> Fold<T>::pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const {
  return plane_.height(p) < 0 ? plane_.imageOfDirection(gradient) : gradient;
}

template <std::floating_point T>
SurfacePoint<T> Fold<T>::localClosestPoint(const Vec3<T>& p) const {
  // The operand's closest point, unless it is on the part that is not kept.
  const auto promise = localGuarantee();
  auto found = this->operand().closestPoint(mapped(p));
  if (plane_.height(p) < 0) found = plane_.image(found, p);
  const T residual = this->localSignedDistance(found.point);
  if (!(std::abs(residual) <= promise.error(length(p) + length(found.point)))) {
    return PointMap<T>::localClosestPoint(p);
  }
  detail::setTolerance(found, p, residual, promise);
  return found;
}

template <std::floating_point T>
BoxClass Fold<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  return sideOf(box) != 0 ? this->classOf(this->operand(), mapped(box))
                          : PointMap<T>::localClassify(box, hint);
}

template <std::floating_point T>
bool Fold<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  const int side = sideOf(box);
  if (side >= 0) this->surfacesOf(this->operand(), box, visit);
  if (side <= 0) {
    this->surfacesOf(Mirror<T>(this->operand(), plane_.point(), plane_.normal()), box, visit);
  }
  // Both may have an edge in common.
  if (side == 0) visit(Plane<T>(plane_.point(), plane_.normal()), nullptr);
  return true;
}

template <std::floating_point T>
Guarantee<T> Fold<T>::localGuarantee() const {
  constexpr auto lower = Quality::LowerBound;
  auto promise = this->operand().guarantee();
  const auto box = this->operand().boundingBox();
  const T size = length(box.lower) + length(box.upper) + length(plane_.point());
  const T rounding = 2 * promise.error(size);  // of the box, which is grown by this much
  const T height = !box.empty() && isFinite(box) ? leastHeight(box) : -Box<T>::kMost;
  if (!(height >= -rounding && std::isfinite(rounding)))
    promise.outside = std::min(promise.outside, lower);
  if (!(height > rounding)) promise.inside = std::min(promise.inside, lower);
  promise.ulps += 14 * promise.lipschitz.value_or(T(1));
  promise.size += plane_.reach() + length(plane_.point());
  const auto mirroredDomain = detail::domainUnder(plane_.map(), plane_.map(), promise.domain);
  promise.domain = promise.domain.intersection(mirroredDomain);
  return promise;
}

template <std::floating_point T>
Box<T> Fold<T>::localBoundingBox() const {
  auto kept = this->operand().boundingBox();
  for (int axis = 0; axis < 3; ++axis) {
    const auto& normal = plane_.normal();
    if (!isAlong(normal, axis)) continue;
    auto& side = normal[axis] > 0 ? kept.lower : kept.upper;
    side[axis] = normal[axis] > 0 ? std::max(side[axis], plane_.point()[axis])
                                  : std::min(side[axis], plane_.point()[axis]);
  }
  if (kept.empty()) return {};
  return localGuarantee().grown(kept.extend(plane_.map()(kept)));
}

template <std::floating_point T>
Box<T> Fold<T>::localClearanceBox() const {
  const auto box = this->operand().clearanceBox();
  return localGuarantee().grown(Box<T>(box).extend(plane_.map()(box)));
}

template class Fold<float>;
template class Fold<double>;

}  // namespace cutwater
