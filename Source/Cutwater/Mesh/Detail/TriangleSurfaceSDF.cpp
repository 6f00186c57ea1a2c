#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/ClippedSegment.hpp>
#include <Cutwater/Mesh/Detail/MeshCrossings.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceSDF.hpp>
#include <Cutwater/Text/Counted.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// From this distance on, the whole surface, of size 1, is a point within rounding, but squares do
/// not yet overflow. Points beyond are pulled in along their ray.
template <std::floating_point T>
constexpr T kFarthest = T(0x1p60);

/// The least depth of a point inside a closed surface, so that a point whose distance rounds to 0
/// keeps its sign: far below any error, but still not 0 after division by a surface's scale.
template <std::floating_point T>
constexpr T kLeastDepth = T(sizeof(T) == sizeof(float) ? 0x1p-63 : 0x1p-511);

}  // namespace

template <std::floating_point T>
void TriangleSurfaceSDF<T>::setSurface(const Surface& surface, double margin) {
  surface_ = surface;
  box_ = surfaceBox().grown(static_cast<T>(margin) / surface.scale);
}

template <std::floating_point T>
void TriangleSurfaceSDF<T>::setSigns(const SignReport& signs, SignScheme wanted) {
  signs_ = signs;
  signs_.scheme = wanted != SignScheme::Automatic ? wanted
                  : signs.isSound()               ? SignScheme::NearestFeature
                                                  : SignScheme::WindingNumber;
  const bool byNearest = signs_.scheme == SignScheme::NearestFeature;
  signJumps_ = byNearest ? !signs_.isSound() : !signs_.isClosed();
  // Behind the nearest triangle is inside, however far away.
  if (byNearest && signJumps_) box_ = Box<T>::everywhere();
}

template <std::floating_point T>
Box<T> TriangleSurfaceSDF<T>::surfaceBox() const {
  // The corners are numbers of type T.
  return {static_cast<Vec3<T>>(surface_.box.lower) / surface_.scale,
          static_cast<Vec3<T>>(surface_.box.upper) / surface_.scale};
}

template <std::floating_point T>
std::array<Vec3<T>, 3> TriangleSurfaceSDF<T>::triangle(std::uint32_t id) const {
  require(id < triangleCount(), "triangle: no such triangle", Named{"id", id});
  const auto t = surface_.triangle(id);
  return {t.a / surface_.scale, t.b / surface_.scale, t.c / surface_.scale};
}

template <std::floating_point T>
std::string TriangleSurfaceSDF<T>::localName() const {
  return "Mesh of " + detail::counted(triangleCount(), "triangle", "triangles");
}

template <std::floating_point T>
Vec3<T> TriangleSurfaceSDF<T>::scaled(const Vec3<T>& point) const {
  const Vec3<T> p = surface_.scale * point;
  if (maxComponent(abs(p)) <= kFarthest<T>) return p;
  return kFarthest<T> * (point / maxComponent(abs(point)));
}

template <std::floating_point T>
int TriangleSurfaceSDF<T>::side(const Vec3<T>& p, const Nearest& nearest) const {
  const bool byNearest = signs_.scheme == SignScheme::NearestFeature;
  // The distance of a point beside the surface may round to 0.
  if (!signs_.isClosed() && nearest.distanceSquared == 0 &&
      (byNearest || isOnTriangle(Vec3<double>(p), surface_.corners(nearest.triangle)))) {
    return 0;
  }
  if (byNearest) {
    if (const int agreed = nearest.agreedSide(); agreed != 0) return agreed;
    if (!signs_.isClosed()) return surface_.pseudonormalSide(p, nearest);
  }
  if (!signs_.isClosed()) return isSurrounded(p) ? -1 : 1;
  const auto location = locate(surface_, Vec3<double>(p), search());
  return location.onSurface ? 0 : location.isInside() ? -1 : 1;
}

template <std::floating_point T>
bool TriangleSurfaceSDF<T>::isInside(const Vec3<T>& p) const {
  return side(p, nearest(p)) < 0;
}

template <std::floating_point T>
T TriangleSurfaceSDF<T>::valueAt(const Vec3<T>& point, const Vec3<T>& p,
                                 const Nearest& nearest) const {
  const int side = this->side(p, nearest);
  const bool isFar = maxComponent(abs(p)) >= kFarthest<T>;
  if (isFar) return static_cast<T>(side) * std::hypot(point.x, point.y, point.z);
  const T magnitude = std::sqrt(nearest.distanceSquared);
  const T value =
      side < 0 ? -std::max(magnitude, kLeastDepth<T>) : static_cast<T>(side) * magnitude;
  return value / surface_.scale;
}

template <std::floating_point T>
T TriangleSurfaceSDF<T>::localSignedDistance(const Vec3<T>& point) const {
  const Vec3<T> p = scaled(point);
  return valueAt(point, p, nearest(p));
}

template <std::floating_point T>
bool TriangleSurfaceSDF<T>::leavesBox(const Vec3<T>& point, T radius) const {
  const Vec3<T> gap = max(box_.lower - point, point - box_.upper);
  return maxComponent(gap) + radius > 4 * surface_.error(surface_.scale * point) / surface_.scale;
}

template <std::floating_point T>
T TriangleSurfaceSDF<T>::localSignedDistanceWithin(const Vec3<T>& point,
                                                   const Interval<T>& wanted) const {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const T radius = std::max(wanted.upper, T(0));
  const Vec3<T> p = scaled(point);
  if (!(radius < kInf) || signJumps_ || maxComponent(abs(p)) >= kFarthest<T> ||
      !leavesBox(point, radius)) {
    return localSignedDistance(point);
  }
  const T reach = surface_.scale * radius + 4 * surface_.error(p);
  const auto found = nearestWithin(p, double{reach});
  return found.distanceSquared <= reach * reach ? valueAt(point, p, found) : kInf;
}

template <std::floating_point T>
void TriangleSurfaceSDF<T>::nearest(std::span<const Vec3<T>> points,
                                    std::span<Nearest> nearest) const {
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = this->nearest(points[i]);
}

template <std::floating_point T>
template <typename Visit>
void TriangleSurfaceSDF<T>::forNearest(std::span<const Vec3<T>> points, Visit visit) const {
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto count = std::min(kBatch, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) p[i] = scaled(points[begin + i]);
    this->nearest(p.first(count), nearest.first(count));
    for (std::size_t i = 0; i < count; ++i) visit(begin + i, p[i], nearest[i]);
  }
}

template <std::floating_point T>
void TriangleSurfaceSDF<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                                 std::span<T> distances) const {
  forNearest(points, [&](std::size_t i, const Vec3<T>& p, const Nearest& nearest) {
    distances[i] = valueAt(points[i], p, nearest);
  });
}

template <std::floating_point T>
SurfacePoint<T> TriangleSurfaceSDF<T>::localClosestPoint(const Vec3<T>& point) const {
  const Vec3<T> p = scaled(point);
  return closestPointAt(point, p, nearest(p));
}

template <std::floating_point T>
void TriangleSurfaceSDF<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                               std::span<SurfacePoint<T>> results) const {
  forNearest(points, [&](std::size_t i, const Vec3<T>& p, const Nearest& nearest) {
    results[i] = closestPointAt(points[i], p, nearest);
  });
}

template <std::floating_point T>
SurfacePoint<T> TriangleSurfaceSDF<T>::closestPointAt(const Vec3<T>& point, const Vec3<T>& p,
                                                      const Nearest& nearest) const {
  auto result = surface_.surfacePoint(p, nearest);
  result.distance = valueAt(point, p, nearest);
  // Where shells overlap, the nearest triangle need not be part of the solid's surface; and a place
  // where the sign jumps may be nearer than any.
  result.exact = signs_.isSound() && nearest.triangle != kNone;
  if (signJumps_) result.tolerance = std::numeric_limits<T>::infinity();
  return result;
}

template <std::floating_point T>
Vec3<T> TriangleSurfaceSDF<T>::localGradient(const Vec3<T>& point) const {
  const auto hit = localClosestPoint(point);
  const Vec3<T> away = hit.distance < 0 ? hit.point - point : point - hit.point;
  const T rounding = 2 * surface_.error(scaled(point)) / surface_.scale;
  // On the surface the direction is lost to rounding; its limit is the pseudonormal.
  return std::abs(hit.distance) > 64 * rounding ? normalized(away) : hit.normal;
}

template <std::floating_point T>
SurfaceOwner TriangleSurfaceSDF<T>::localOwner(const Vec3<T>& point) const {
  return localClosestPoint(point).owner;
}

template <std::floating_point T>
bool TriangleSurfaceSDF<T>::isJumpFree(const Box<double>& box) const {
  if (!signJumps_) return true;
  // Where the sign flips as another triangle becomes the nearest is not known.
  return signs_.scheme == SignScheme::WindingNumber && isDecided(box);
}

template <std::floating_point T>
bool TriangleSurfaceSDF<T>::hasNoJump(const Box<T>& box) const {
  const double scale{surface_.scale};
  return isJumpFree({scale * Vec3<double>(box.lower), scale * Vec3<double>(box.upper)});
}

template <std::floating_point T>
CrossingCount TriangleSurfaceSDF<T>::localCrossings(const Segment<T>& segment,
                                                    CrossingVisitor<T> visit) const {
  const Segment<T> ends{scaled(segment.start), scaled(segment.end)};
  if (ends.start == ends.end) return {};
  const auto near = nearPart(segment);
  const auto restored = [&](Crossing<T> crossing) {
    crossing.parameter =
        static_cast<T>(near.start + double{crossing.parameter} * (near.end - near.start));
    return visit(crossing);
  };
  const bool byWinding = signJumps_ && signs_.scheme == SignScheme::WindingNumber;
  return meshCrossings<T>({.surface = surface_,
                           .along = search(),
                           .nearest = [this](const Vec3<T>& p) { return nearest(p); },
                           .isInside = [this](const Vec3<T>& p) { return isInside(p); },
                           .winding = byWinding ? openWinding() : nullptr,
                           .isClosed = !signJumps_},
                          {.ends = ends, .searched = near.part}, restored);
}

template <std::floating_point T>
ClippedSegment TriangleSurfaceSDF<T>::nearPart(const Segment<T>& segment) const {
  constexpr double kNear = 0x1p20;  // beyond, rounding would be coarse relative to the surface
  const double scale{surface_.scale};
  const bool isBounded = !signJumps_ || signs_.scheme == SignScheme::WindingNumber;
  // By pseudonormals the sign may change anywhere.
  Box<double> box =
      isBounded ? Box<double>{Vec3<double>(box_.lower), Vec3<double>(box_.upper)}.grown(1 / scale)
                : Box<double>{}.extend(Vec3<double>{}).grown(kNear / scale);
  const Segment<double> whole{Vec3<double>(segment.start), Vec3<double>(segment.end)};
  for (const auto& p : {whole.start, whole.end}) {
    if (maxComponent(abs(scale * p)) <= kNear) box.extend(p);
  }
  // Far ends without anything in between do not meet the surface: then, one of them.
  const Vec3<double> start(scaled(segment.start));
  auto result = clipped(whole, box);
  if (!result) return {{start, start}};
  result->part = {scale * result->part.start, scale * result->part.end};
  return *result;
}

template <std::floating_point T>
Guarantee<T> TriangleSurfaceSDF<T>::localGuarantee() const {
  auto result = Guarantee<T>::exact(surface_.size / surface_.scale);
  if (signs_.isSound()) return result;
  // The distance to the nearest triangle, whether or not it is on the surface of the union.
  result.outside = result.inside = Quality::LowerBound;
  if (!signJumps_) return result;
  result.outside = result.inside = Quality::SignOnly;
  result.lipschitz.reset();
  result.continuous = false;
  return result;
}

template class TriangleSurfaceSDF<float>;
template class TriangleSurfaceSDF<double>;

}  // namespace cutwater
