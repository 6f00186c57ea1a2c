#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Detail/SpatialOrder.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cutwater {

namespace {

using detail::kEps;

template <std::floating_point T>
constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();

/// Points are passed to the shapes in batches of this size, whose local copies fit the L1 cache.
constexpr std::size_t kPointBatch = 256;

/// The answer for a point that is not finite.
template <std::floating_point T>
SurfacePoint<T> noSurfacePoint() {
  SurfacePoint<T> none;
  none.point = none.normal = {kNaN<T>, kNaN<T>, kNaN<T>};
  none.owner.patch = kNone;
  return none;
}

/// Fewer points are not worth ordering.
constexpr std::size_t kWorthOrdering = std::size_t{1} << 17U;

/// a - b if that needs no rounding (Knuth's TwoSum), otherwise NaN.
template <std::floating_point T>
T exactDifference(T a, T b) {
  const T difference = a - b;
  const T ofB = a - difference;
  const T ofA = difference + ofB;
  return ofA == a && ofB == b ? difference : kNaN<T>;
}

/// The box in the frame of an object that is only translated, if no coordinate is rounded.
template <std::floating_point T>
std::optional<Box<T>> exactlyMoved(const Box<T>& world, const RigidTransform<T>& placement) {
  Box<T> local;
  for (int axis = 0; axis < 3; ++axis) {
    local.lower[axis] = exactDifference(world.lower[axis], placement.offset()[axis]);
    local.upper[axis] = exactDifference(world.upper[axis], placement.offset()[axis]);
  }
  return isFinite(local) ? std::optional(local) : std::nullopt;
}

}  // namespace

template <std::floating_point T>
T SignedDistanceFunction<T>::signedDistance(const Vec3<T>& point) const {
  if (!isFinite(point)) return kNaN<T>;
  return localSignedDistance(placement_.toLocal(point)) + T(0);  // -0 becomes +0
}

template <std::floating_point T>
void SignedDistanceFunction<T>::signedDistances(std::span<const Vec3<T>> points,
                                                std::span<T> distances,
                                                const ParallelOptions& options) const {
  require(points.size() == distances.size(), "signedDistances: need one distance per point",
          Named{"points", points.size()}, Named{"distances", distances.size()});
  forLocalPoints<T>(points, distances, options, kNaN<T>,
                    [&](std::span<const Vec3<T>> local, std::span<T> values) {
                      localSignedDistances(local, values);
                      for (auto& value : values) value += T(0);  // -0 becomes +0
                    });
}

template <std::floating_point T>
bool SignedDistanceFunction<T>::signedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                                      std::span<T> distances) const {
  require(points.size() == distances.size(), "signedDistancesWithin: need one distance per point",
          Named{"points", points.size()}, Named{"distances", distances.size()});
  if (!localSignedDistancesWithin({}, limit, {})) return false;
  forLocalPoints<T>(points, distances, {.threads = 1}, kNaN<T>,
                    [&](std::span<const Vec3<T>> local, std::span<T> values) {
                      static_cast<void>(localSignedDistancesWithin(local, limit, values));
                      for (auto& value : values) value += T(0);  // -0 becomes +0
                    });
  return true;
}

template <std::floating_point T>
template <typename Result>
void SignedDistanceFunction<T>::forLocalPoints(
    std::span<const Vec3<T>> points, std::span<Result> results, const ParallelOptions& options,
    const Result& refused,
    FunctionRef<void(std::span<const Vec3<T>>, std::span<Result>)> answer) const {
  // In the order of the batch, as far as it is one.
  const auto answerBatch = [&](std::span<const Vec3<T>> world, std::span<Result> found) {
    Scratch<Vec3<T>, kPointBatch> scratch;
    const auto local = scratch.first(world.size());
    placement_.toLocal(world, local);
    bool areFinite = true;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (isFinite(world[i])) continue;
      local[i] = {};
      areFinite = false;
    }
    answer(local, found);
    if (areFinite) return;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!isFinite(world[i])) found[i] = refused;
    }
  };
  std::vector<std::uint32_t> order;
  if (points.size() >= kWorthOrdering && localGainsFromNeighbours()) {
    order = detail::spatialOrder(points, options.threads);
  }
  const auto visit = [&](std::size_t first, std::size_t count) {
    if (order.empty())
      return answerBatch(points.subspan(first, count), results.subspan(first, count));
    Scratch<Vec3<T>, kPointBatch> world;
    Scratch<Result, kPointBatch> found;
    for (std::size_t i = 0; i < count; ++i) world[i] = points[order[first + i]];
    answerBatch(world.first(count), found.first(count));
    for (std::size_t i = 0; i < count; ++i) results[order[first + i]] = found[i];
  };
  detail::parallelBatches(points.size(), kPointBatch, options, visit);
}

template <std::floating_point T>
Vec3<T> SignedDistanceFunction<T>::normal(const Vec3<T>& point, T delta) const {
  if (!isFinite(point)) return {kNaN<T>, kNaN<T>, kNaN<T>};
  if (!(delta > 0)) return {};
  const auto n = normalized(detail::centredDifferences<T>(
      [this](const Vec3<T>& p) { return signedDistance(p); }, point, delta));
  return isFinite(n) ? n : Vec3<T>{};
}

template <std::floating_point T>
Vec3<T> SignedDistanceFunction<T>::gradient(const Vec3<T>& point) const {
  if (!isFinite(point)) return {kNaN<T>, kNaN<T>, kNaN<T>};
  return placement_.directionToWorld(localGradient(placement_.toLocal(point)));
}

template <std::floating_point T>
SurfacePoint<T> SignedDistanceFunction<T>::closestPoint(const Vec3<T>& point) const {
  if (!isFinite(point)) return noSurfacePoint<T>();
  return toWorld(localClosestPoint(placement_.toLocal(point)));
}

template <std::floating_point T>
void SignedDistanceFunction<T>::closestPoints(std::span<const Vec3<T>> points,
                                              std::span<SurfacePoint<T>> results,
                                              const ParallelOptions& options) const {
  require(points.size() == results.size(), "closestPoints: need one result per point",
          Named{"points", points.size()}, Named{"results", results.size()});
  forLocalPoints<SurfacePoint<T>>(
      points, results, options, noSurfacePoint<T>(),
      [&](std::span<const Vec3<T>> local, std::span<SurfacePoint<T>> found) {
        localClosestPoints(local, found);
        for (auto& result : found) result = toWorld(result);
      });
}

template <std::floating_point T>
SurfacePoint<T> SignedDistanceFunction<T>::toWorld(SurfacePoint<T> local) const {
  local.point = placement_.toWorld(local.point);
  // Of the query's point on its way to the shape, and of this one on its way back.
  if (!placement_.isIdentity()) {
    local.tolerance += 2 * placementError(length(local.point) + std::abs(local.distance));
  }
  local.normal = placement_.directionToWorld(local.normal);
  local.distance += T(0);  // -0 becomes +0
  return local;
}

template <std::floating_point T>
SurfaceOwner SignedDistanceFunction<T>::owner(const Vec3<T>& surfacePoint) const {
  if (!isFinite(surfacePoint)) return {.patch = kNone};
  return localOwner(placement_.toLocal(surfacePoint));
}

template <std::floating_point T>
CrossingCount SignedDistanceFunction<T>::crossings(const Segment<T>& segment,
                                                   CrossingVisitor<T> visit) const {
  if (!isFinite(segment.start) || !isFinite(segment.end)) return {};
  const Segment<T> local{placement_.toLocal(segment.start), placement_.toLocal(segment.end)};
  return localCrossings(local,
                        [&](const Crossing<T>& crossing) { return visit(toWorld(crossing)); });
}

template <std::floating_point T>
Crossing<T> SignedDistanceFunction<T>::toWorld(Crossing<T> local) const {
  local.point = placement_.toWorld(local.point);
  local.normal = placement_.directionToWorld(local.normal);
  return local;
}

template <std::floating_point T>
Interval<T> SignedDistanceFunction<T>::bounds(const Box<T>& box, BoxHint* hint) const {
  if (box.empty() || !isFinite(box)) return Interval<T>::everything();
  const auto range = localBounds(toLocal(box), hint);
  // Not a number where squares of coordinates overflow.
  return range.lower <= range.upper ? range : Interval<T>::everything();
}

template <std::floating_point T>
Interval<T> SignedDistanceFunction<T>::distanceBounds(const Box<T>& box, BoxHint* hint) const {
  const auto range = bounds(box, hint);
  const auto promise = guarantee();
  if (!promise.domain.contains(box.lower) || !promise.domain.contains(box.upper)) {
    return {0, std::numeric_limits<T>::infinity()};
  }
  return detail::distanceRange(range, promise);
}

template <std::floating_point T>
BoxClass SignedDistanceFunction<T>::classify(const Box<T>& box, BoxHint* hint) const {
  if (box.empty() || !isFinite(box)) return BoxClass::Unknown;
  return localClassify(toLocal(box), hint);
}

template <std::floating_point T>
bool SignedDistanceFunction<T>::facetsIn(const Box<T>& box, FacetVisitor<T> visit) const {
  if (box.empty() || !isFinite(box)) return true;
  return facetsOf(*this, OrientedBox<T>::of(box), visit);
}

template <std::floating_point T>
bool SignedDistanceFunction<T>::facetsOf(const SignedDistanceFunction& operand,
                                         const OrientedBox<T>& box, FacetVisitor<T> visit) {
  const auto& placement = operand.placement_;
  if (placement.isIdentity()) return operand.localFacetsIn(box, visit);
  return operand.localFacetsIn(operand.toLocal(box), [&](SurfaceFacet<T> facet) {
    for (auto& corner : facet.corners) corner = placement.toWorld(corner);
    for (auto& normal : facet.across) normal = placement.directionToWorld(normal);
    facet.normal = placement.directionToWorld(facet.normal);
    return visit(facet);
  });
}

template <std::floating_point T>
void SignedDistanceFunction<T>::surfacesOf(const Solid<T>& operand, const OrientedBox<T>& box,
                                           SurfaceVisitor<T> visit) {
  const auto& placement = operand.placement();
  const auto placed = [&](Solid<T> solid) {
    solid.setPlacement(RigidTransform<T>::composed(solid.placement(), placement));
    return solid;
  };
  const auto visitPlaced = [&](const Solid<T>& surface, const Solid<T>* of) {
    const auto here = placed(surface);
    if (of == nullptr) return visit(here, &operand);
    if (of == &surface) return visit(here, &here);
    const auto ofHere = placed(*of);
    visit(here, &ofHere);
  };
  const SignedDistanceFunction& shape = operand;
  if (!shape.localSurfacesIn(operand.toLocal(box), visitPlaced)) visit(operand, &operand);
}

template <std::floating_point T>
Guarantee<T> SignedDistanceFunction<T>::guarantee() const {
  return detail::placed(localGuarantee(), placement_);
}

template <std::floating_point T>
std::optional<T> SignedDistanceFunction<T>::lipschitzIn(const Box<T>& box) const {
  if (box.empty() || !isFinite(box)) return {};
  return localLipschitzIn(toLocal(box));
}

template <std::floating_point T>
Box<T> SignedDistanceFunction<T>::boundingBox() const {
  return placement_.toWorld(localBoundingBox());
}

template <std::floating_point T>
Box<T> SignedDistanceFunction<T>::clearanceBox() const {
  return placement_.toWorld(localClearanceBox());
}

template <std::floating_point T>
OrientedBox<T> SignedDistanceFunction<T>::toLocal(const OrientedBox<T>& box) const {
  if (placement_.isIdentity()) return box;
  OrientedBox<T> local = box;
  local.exact.reset();
  if (box.exact && !placement_.isRotated()) local.exact = exactlyMoved(*box.exact, placement_);
  local.center = placement_.toLocal(box.center);
  for (auto& half : local.halfAxis) half = placement_.directionToLocal(half);
  // Once for the centre, once for the other points of the box and for sums of centre and half axes.
  local.slack += 2 * placementError(length(box.center) + box.radius());
  return local;
}

template <std::floating_point T>
OrientedBox<T> SignedDistanceFunction<T>::toLocal(const Box<T>& box) const {
  auto world = OrientedBox<T>::of(box);
  world.exact = box;
  return toLocal(world);
}

/// The most by which rounding moves points, up to this far from the world's origin, on the way to
/// the shape's frame or back. The translation rounds by an ulp of its result, the rotation (three
/// products and two sums per component, columns orthonormal to 2 eps) by less than 8.
template <std::floating_point T>
T SignedDistanceFunction<T>::placementError(T reach) const {
  return (placement_.isRotated() ? T(14) : T(2)) * kEps<T> * (reach + length(placement_.offset()));
}

template class SignedDistanceFunction<float>;
template class SignedDistanceFunction<double>;

}  // namespace cutwater
