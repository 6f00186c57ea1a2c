#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
BoxFrame<T>::BoxFrame(const Box<T>& box, T thickness)
    : box_(box),
      half_(T(0.5) * box.size()),
      hollow_(half_ - Vec3<T>{thickness, thickness, thickness}) {
  require(isFinite(box) && half_.x > 0 && half_.y > 0 && half_.z > 0,
          "BoxFrame: need finite corners with lower < upper", Named{"lower", box.lower},
          Named{"upper", box.upper});
  const T shortest = 2 * -maxComponent(-half_);
  require(thickness > 0 && 2 * thickness < shortest,
          "BoxFrame: need 0 < thickness < half the shortest side", Named{"thickness", thickness},
          Named{"shortest side", shortest});
}

template <std::floating_point T>
Vec3<T> BoxFrame<T>::toFace(const Vec3<T>& q, int axis) const {
  Vec3<T> step;
  step[axis] = half_[axis] - q[axis];
  return step;
}

template <std::floating_point T>
Vec3<T> BoxFrame<T>::toHollow(const Vec3<T>& q, int axis) const {
  Vec3<T> step = -max(q - hollow_, Vec3<T>{});
  step[axis] = 0;
  return step;
}

template <std::floating_point T>
Vec3<T> BoxFrame<T>::toBar(const Vec3<T>& q, int axis) const {
  Vec3<T> step = max(hollow_ - q, Vec3<T>{}) - max(q - half_, Vec3<T>{});
  if (step[axis] > 0) step[axis] = 0;
  return step;
}

template <std::floating_point T>
auto BoxFrame<T>::shortest(const Vec3<T>& q) const -> Step {
  // Inside, the surface is at the nearest of all ways out of the frame; outside, of all ways in.
  Step best{{}, true, true};
  T least = std::numeric_limits<T>::infinity();
  const auto offer = [&](const Vec3<T>& step, T squared) {
    // Steps to almost the same point may differ although their squares are equal.
    const T apart = lengthSquared(step - best.toSurface);
    if (squared == least && apart > 16 * std::numeric_limits<T>::epsilon() * least) {
      best.isUnique = false;
    }
    if (!(squared < least)) return;
    least = squared;
    best.toSurface = step;
    best.isUnique = true;
  };
  for (int axis = 0; axis < 3 && best.isInside; ++axis) {
    const auto face = toFace(q, axis);
    const auto hollow = toHollow(q, axis);
    best.isInside = face[axis] > 0 && hollow != Vec3<T>{};
    offer(face, lengthSquared(face));
    offer(hollow, lengthSquared(hollow));
  }
  if (best.isInside) return best;
  least = std::numeric_limits<T>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const auto bar = toBar(q, axis);
    offer(bar, lengthSquared(bar));
  }
  return best;
}

template <std::floating_point T>
T BoxFrame<T>::localSignedDistance(const Vec3<T>& p) const {
  const auto step = shortest(abs(p - box_.center()));
  const T distance = length(step.toSurface);
  return step.isInside ? -distance : distance;
}

template <std::floating_point T>
Vec3<T> BoxFrame<T>::localGradient(const Vec3<T>& p) const {
  const Vec3<T> fromCenter = p - box_.center();
  const auto step = shortest(abs(fromCenter));
  if (!step.isUnique) return {};
  Vec3<T> outward = step.isInside ? step.toSurface : -step.toSurface;
  if (outward == Vec3<T>{}) return SignedDistanceFunction<T>::localGradient(p);  // on the surface
  for (int axis = 0; axis < 3; ++axis) {
    // The point is midway between two equally near bars.
    if (fromCenter[axis] == 0 && outward[axis] != 0) return {};
    if (fromCenter[axis] < 0) outward[axis] = -outward[axis];
  }
  return normalized(outward);
}

template <std::floating_point T>
SurfacePoint<T> BoxFrame<T>::localClosestPoint(const Vec3<T>& p) const {
  const Vec3<T> fromCenter = p - box_.center();
  auto [step, isInside, isUnique] = shortest(abs(fromCenter));
  if (step == Vec3<T>{}) return SignedDistanceFunction<T>::localClosestPoint(p);
  const T distance = length(step);
  for (int axis = 0; axis < 3; ++axis) {
    if (fromCenter[axis] < 0) step[axis] = -step[axis];
  }
  SurfacePoint<T> result;
  result.point = p + step;
  result.normal = normalized(isInside ? step : -step);
  result.distance = isInside ? -distance : distance;
  detail::setTolerance(result, p, localSignedDistance(result.point), localGuarantee());
  return result;
}

template <std::floating_point T>
bool BoxFrame<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  for (const auto& half : {half_, hollow_}) {
    detail::visitSides<T>({box_.center() - half, box_.center() + half}, visit);
  }
  return true;
}

template <std::floating_point T>
Guarantee<T> BoxFrame<T>::localGuarantee() const {
  return Guarantee<T>::exact(detail::farther(box_.lower, box_.upper));
}

template <std::floating_point T>
Box<T> BoxFrame<T>::localBoundingBox() const {
  return localGuarantee().grown(box_);
}

template class BoxFrame<float>;
template class BoxFrame<double>;

}  // namespace cutwater
