#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

/// What SignedDistanceFunction answers for a shape that says no better: only values and a guarantee
/// are used.
namespace cutwater::detail {

/// A function as the algorithms below see it.
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

/// A surface point near `p`, by steps f grad f / |grad f|^2. One step is exact for an exact signed
/// distance, from one of the nearest points where there are several; the rest removes rounding, or
/// walks to the surface of a mere bound.
template <std::floating_point T>
SurfacePoint<T> projectedPoint(const Field<T>& field, const Vec3<T>& p);

/// The surface point in one step of this value against this gradient, which is a unit vector or
/// zero: for the least of several distances that are exact, each with its own gradient. None where
/// that leads into another one, or there is no gradient.
template <std::floating_point T>
std::optional<SurfacePoint<T>> steppedPoint(FunctionRef<T(const Vec3<T>&)> value, const Vec3<T>& p,
                                            T atP, const Vec3<T>& gradient,
                                            const Guarantee<T>& guarantee);

/// Fills in what is known about how near `result.point` is to the surface point nearest to `p`,
/// where the function has the value result.distance; `residual` is the value at result.point.
template <std::floating_point T>
void rate(SurfacePoint<T>& result, const Vec3<T>& p, T residual, const Guarantee<T>& guarantee);

/// Crossings isolated by the Lipschitz constant: a stretch with ends of one sign has none if
/// |f(a)| + |f(b)| > L |b - a|. Others are halved until rounding is reached, or, once a budget is
/// used up or if there is no constant, down to 1/4096 of the segment; a change of sign is then
/// bisected to rounding.
template <std::floating_point T>
CrossingCount isolatedCrossings(const Field<T>& field, const Segment<T>& segment,
                                CrossingVisitor<T> visit);

/// Bounds of the values in a box within the guarantee's domain, from the one at its centre and the
/// Lipschitz constant, which there must be.
template <std::floating_point T>
Interval<T> boundsAround(T atCenter, const OrientedBox<T>& box, const Guarantee<T>& guarantee);

/// The same made tighter: by a range that encloses the function's exact values in the box, computed
/// with no more rounding than a value.
template <std::floating_point T>
Interval<T> boundsWithin(const Interval<T>& range, T atCenter, const OrientedBox<T>& box,
                         const Guarantee<T>& guarantee);

/// Encloses the distance to the surface wherever the value is in the range, within the guarantee's
/// domain: see SignedDistanceFunction::distanceBounds().
template <std::floating_point T>
Interval<T> distanceRange(const Interval<T>& values, const Guarantee<T>& guarantee);

/// The guarantee of a moved function.
template <std::floating_point T>
Guarantee<T> placed(Guarantee<T> local, const RigidTransform<T>& placement);

}  // namespace cutwater::detail
