#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

/// Default answers of SignedDistanceFunction for shapes that do not provide better ones. They use
/// only values and a guarantee.
namespace cutwater::detail {

/// A function as the algorithms below use it.
template <std::floating_point T>
struct Field {
  FunctionRef<T(const Vec3<T>&)> value;
  FunctionRef<Vec3<T>(const Vec3<T>&)> gradient;
  FunctionRef<SurfaceOwner(const Vec3<T>&)> owner;
  Guarantee<T> guarantee;
};

/// f(p + delta e_i) - f(p - delta e_i) for i = x, y, z.
template <std::floating_point T>
Vec3<T> centredDifferences(FunctionRef<T(const Vec3<T>&)> value, const Vec3<T>& p, T delta) {
  const auto difference = [&](const Vec3<T>& d) { return value(p + d) - value(p - d); };
  return {difference({delta, 0, 0}), difference({0, delta, 0}), difference({0, 0, delta})};
}

/// A surface point near `p`, found by steps f grad f / |grad f|^2. For an exact signed distance one
/// step reaches a nearest point exactly (one of them if there are several). Further steps remove
/// rounding or, where values are only bounds, approach the surface.
template <std::floating_point T>
SurfacePoint<T> projectedPoint(const Field<T>& field, const Vec3<T>& p);

/// The surface point reached by one step of size `atP`, the value at `p`, against `gradient`, a
/// unit vector or zero. Meant for the minimum of several exact distances, each with its own
/// gradient. None if the step ends inside another operand, or if there is no gradient.
template <std::floating_point T>
std::optional<SurfacePoint<T>> steppedPoint(FunctionRef<T(const Vec3<T>&)> value, const Vec3<T>& p,
                                            T atP, const Vec3<T>& gradient,
                                            const Guarantee<T>& guarantee);

/// Sets result.tolerance and result.exact: how near result.point is to the surface point nearest to
/// `p`, where the function has the value result.distance. Leaves them alone if the guarantee does
/// not hold at `p`. `residual` is the value at result.point.
template <std::floating_point T>
void setTolerance(SurfacePoint<T>& result, const Vec3<T>& p, T residual,
                  const Guarantee<T>& guarantee);

/// Finds crossings with the Lipschitz constant: a stretch whose ends have the same sign has none if
/// |f(a)| + |f(b)| > L |b - a|. Other stretches are halved down to rounding or, if there is no
/// constant for them or a budget is used up, to 1/4096 of the segment; but only to 1/16 of it where
/// they seem to lie in the surface. A change of sign is then bisected down to rounding. The budget
/// limits the work to about 2e5 values, whatever the function and the segment.
template <std::floating_point T>
CrossingCount isolatedCrossings(const Field<T>& field, const Segment<T>& segment,
                                CrossingVisitor<T> visit);
/// The same, to the bit, for many segments side by side. `values` has the field's values at a few
/// dozen points.
template <std::floating_point T>
void isolatedCrossings(const Field<T>& field,
                       FunctionRef<void(std::span<const Vec3<T>>, std::span<T>)> values,
                       std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                       CrossingsVisitor<T> visit);

/// Bounds of the values in a box within the guarantee's domain, from the value at its centre and
/// the Lipschitz constant, which is required.
template <std::floating_point T>
Interval<T> boundsAround(T atCenter, const OrientedBox<T>& box, const Guarantee<T>& guarantee);

/// The same, tightened by a range that encloses the function's exact values in the box and is
/// computed with no more rounding than a value.
template <std::floating_point T>
Interval<T> boundsWithin(const Interval<T>& range, T atCenter, const OrientedBox<T>& box,
                         const Guarantee<T>& guarantee);

/// Encloses the distance to the surface wherever the value is in the range, within the guarantee's
/// domain: see SignedDistanceFunction::distanceBounds().
template <std::floating_point T>
Interval<T> distanceRange(const Interval<T>& values, const Guarantee<T>& guarantee);

/// The guarantee of the function after it has been moved.
template <std::floating_point T>
Guarantee<T> placed(Guarantee<T> local, const RigidTransform<T>& placement);

}  // namespace cutwater::detail
