#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/Detail/PointAnswers.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// The least depth of a point inside a closed surface, so that a point whose distance rounds to 0
/// keeps its sign: far below any error, but still not 0 after division by a surface's scale.
template <std::floating_point T>
constexpr T kLeastDepth = T(sizeof(T) == sizeof(float) ? 0x1p-63 : 0x1p-511);

}  // namespace

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::pulledIn(const Vec3<T>& point) {
  return kFarthest * (point / maxComponent(abs(point)));
}

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::scale(std::span<const Vec3<T>> points, std::span<Vec3<T>> p) const {
  Vec3<T> most;
  for (std::size_t i = 0; i < points.size(); ++i) {
    p[i] = surface().scale * points[i];
    most = max(most, abs(p[i]));
  }
  if (maxComponent(most) <= kFarthest) return most;
  for (std::size_t i = 0; i < points.size(); ++i) p[i] = scaled(points[i]);
  return {kFarthest, kFarthest, kFarthest};
}

template <std::floating_point T, typename Index>
int PointAnswers<T, Index>::disputedSide(const Vec3<T>& p, const Nearest& nearest) const {
  const bool byNearest = signs().scheme == SignScheme::NearestFeature;
  // The distance of a point beside the surface may round to 0.
  if (!signs().isClosed() && nearest.distanceSquared == 0 &&
      (byNearest || isOnTriangle(Vec3<double>(p), surface().corners(nearest.triangle)))) {
    return 0;
  }
  if (byNearest) {
    if (const int agreed = nearest.agreedSide(); agreed != 0) return agreed;
    if (!signs().isClosed()) return surface().pseudonormalSide(p, nearest);
  }
  if (!signs().isClosed()) return index_.isSurrounded(p, nearest) ? -1 : 1;
  if (const auto beside = index_.windingBeside(p, nearest)) return *beside >= 1 ? -1 : 1;
  const auto location = locate(surface(), Vec3<double>(p), index_.trianglesAlong());
  return location.onSurface ? 0 : location.isInside() ? -1 : 1;
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::isInside(const Vec3<T>& p) const {
  return side(p, index_.nearest(p)) < 0;
}

template <std::floating_point T, typename Index>
T PointAnswers<T, Index>::valueAt(const Vec3<T>& point, const Vec3<T>& p,
                                  const Nearest& nearest) const {
  const int side = this->side(p, nearest);
  const bool isFar = maxComponent(abs(p)) >= kFarthest;
  if (isFar) return static_cast<T>(side) * std::hypot(point.x, point.y, point.z);
  const T magnitude = std::sqrt(nearest.distanceSquared);
  const T value =
      side < 0 ? -std::max(magnitude, kLeastDepth<T>) : static_cast<T>(side) * magnitude;
  return value / surface().scale;
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::leavesBox(const Vec3<T>& point, T radius) const {
  const Vec3<T> gap = max(index_.solidBox().lower - point, point - index_.solidBox().upper);
  return maxComponent(gap) + radius >
         4 * surface().error(surface().scale * point) / surface().scale;
}

template <std::floating_point T, typename Index>
T PointAnswers<T, Index>::signedDistanceWithin(const Vec3<T>& point,
                                               const Interval<T>& wanted) const {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const T radius = std::max(wanted.upper, T(0));
  const Vec3<T> p = scaled(point);
  if (!(radius < kInf) || index_.signJumps() || maxComponent(abs(p)) >= kFarthest ||
      !leavesBox(point, radius)) {
    return signedDistance(point);
  }
  const T reach = surface().scale * radius + 4 * surface().error(p);
  const auto found = index_.nearestWithin(p, double{reach});
  return found.distanceSquared <= reach * reach ? valueAt(point, p, found) : kInf;
}

template <std::floating_point T, typename Index>
template <typename Visit>
void PointAnswers<T, Index>::forNearest(std::span<const Vec3<T>> points, Visit visit) const {
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto count = std::min(kBatch, points.size() - begin);
    static_cast<void>(scale(points.subspan(begin, count), p.first(count)));
    index_.nearest(p.first(count), nearest.first(count));
    for (std::size_t i = 0; i < count; ++i) visit(begin + i, p[i], nearest[i]);
  }
}

template <std::floating_point T, typename Index>
void PointAnswers<T, Index>::signedDistances(std::span<const Vec3<T>> points,
                                             std::span<T> distances) const {
  forNearest(points, [&](std::size_t i, const Vec3<T>& p, const Nearest& nearest) {
    distances[i] = valueAt(points[i], p, nearest);
  });
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::signedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                                   std::span<T> distances) const {
  if (index_.signJumps()) return false;
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto count = std::min(kBatch, points.size() - begin);
    const Vec3<T> farthest = scale(points.subspan(begin, count), p.first(count));
    const T reach = surface().scale * limit + 4 * surface().error(farthest);
    index_.nearestWithin(p.first(count), nearest.first(count), double{reach});
    for (std::size_t i = 0; i < count; ++i) {
      const bool isNear =
          nearest[i].triangle != kNone && nearest[i].distanceSquared <= reach * reach;
      distances[begin + i] = isNear ? valueAt(points[begin + i], p[i], nearest[i])
                                    : std::numeric_limits<T>::quiet_NaN();
    }
  }
  return true;
}

template <std::floating_point T, typename Index>
void PointAnswers<T, Index>::closestPoints(std::span<const Vec3<T>> points,
                                           std::span<SurfacePoint<T>> results) const {
  forNearest(points, [&](std::size_t i, const Vec3<T>& p, const Nearest& nearest) {
    results[i] = closestPointAt(points[i], p, nearest);
  });
}

template <std::floating_point T, typename Index>
SurfacePoint<T> PointAnswers<T, Index>::closestPointAt(const Vec3<T>& point, const Vec3<T>& p,
                                                       const Nearest& nearest) const {
  auto result = surface().surfacePoint(p, nearest);
  result.distance = valueAt(point, p, nearest);
  // Where shells overlap, the nearest triangle need not be part of the solid's surface; and a place
  // where the sign jumps may be nearer than any.
  result.exact = signs().isSound() && nearest.triangle != kNone;
  if (index_.signJumps()) result.tolerance = std::numeric_limits<T>::infinity();
  return result;
}

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::gradient(const Vec3<T>& point) const {
  const auto hit = closestPoint(point);
  const Vec3<T> away = hit.distance < 0 ? hit.point - point : point - hit.point;
  const T rounding = 2 * surface().error(scaled(point)) / surface().scale;
  // On the surface the direction is lost to rounding; its limit is the pseudonormal.
  return std::abs(hit.distance) > 64 * rounding ? normalized(away) : hit.normal;
}

template <std::floating_point T, typename Index>
Guarantee<T> PointAnswers<T, Index>::guarantee() const {
  auto result = Guarantee<T>::exact(surface().size / surface().scale);
  if (signs().isSound()) return result;
  // The distance to the nearest triangle, whether or not it is on the surface of the union.
  result.outside = result.inside = Quality::LowerBound;
  if (!index_.signJumps()) return result;
  result.outside = result.inside = Quality::SignOnly;
  result.lipschitz.reset();
  result.continuous = false;
  return result;
}

template class PointAnswers<float, MeshIndex<float>>;
template class PointAnswers<double, MeshIndex<double>>;
template class PointAnswers<float, DcelIndex<float>>;
template class PointAnswers<double, DcelIndex<double>>;

}  // namespace cutwater
