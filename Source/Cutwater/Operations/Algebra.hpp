#pragma once

#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Core/Repeats.hpp>
#include <Cutwater/Operations/Detail/AlgebraOfSolids.hpp>
#include <Cutwater/Operations/Smoothing.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <string>
#include <vector>

/// Operators and functions that combine solids: they take shapes and Solids alike and return
/// Solids.
///
///     const auto body = offset(hull, 0.1) | translated(mast, {2, 0, 0}) - hatch;
///
/// `-` binds tighter than `&`, `&` tighter than `^`, and `^` tighter than `|`.
namespace cutwater {

/// All points of a or b: the least value. Exact outside if both are, inside a lower bound. Where
/// the two touch face to face, the shared face stays as a surface of value 0. A union of unions is
/// one union with all their operands, in order; if these are many, a tree finds the few that
/// matter.
///
/// SurfaceOwner::object is the number of the operand that the surface belongs to; patches are
/// numbered consecutively, operand by operand. The same holds for everything below that combines
/// several solids.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator|(const A& a, const B& b) {
  return detail::unite<detail::ScalarOf<A>>({a, b});
}

/// All points common to a and b: the greatest value. Exact inside if both are, outside a lower
/// bound. An intersection of intersections is one intersection, as for unions.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator&(const A& a, const B& b) {
  return detail::intersect<detail::ScalarOf<A>>({a, b});
}

/// All points that are not in a: the value with its sign changed, so what a guarantees outside
/// holds inside, and vice versa. Points of value 0 are outside both, as for any solid.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> operator~(const A& a) {
  return detail::complementOf<detail::ScalarOf<A>>(a);
}

/// All points of a that are not in b: the intersection of a with the complement of b.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator-(const A& a, const B& b) {
  return a & ~b;
}

/// All points of a or b, but not of both. Exact if both are, except where the two surfaces
/// coincide: there a value of 0 remains, as between solids that touch in a union, and values nearby
/// are lower bounds.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator^(const A& a, const B& b) {
  return detail::xorOf<detail::ScalarOf<A>>(a, b);
}
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> symmetricDifference(const A& a, const B& b) {
  return a ^ b;
}

/// The union of any number of solids, in one step.
template <SolidLike A, SolidLike... Others>
requires(detail::SameScalar<A, Others>&&...)
    [[nodiscard]] detail::SolidOf<A> unionOf(const A& first, const Others&... others) {
  return detail::unite<detail::ScalarOf<A>>({first, others...});
}
/// @throws Error if the list is empty.
template <std::floating_point T>
[[nodiscard]] Solid<T> unionOf(const std::vector<Solid<T>>& solids) {
  return detail::unite<T>(solids);
}

/// The intersection of any number of solids, in one step.
template <SolidLike A, SolidLike... Others>
requires(detail::SameScalar<A, Others>&&...)
    [[nodiscard]] detail::SolidOf<A> intersectionOf(const A& first, const Others&... others) {
  return detail::intersect<detail::ScalarOf<A>>({first, others...});
}
/// @throws Error if the list is empty.
template <std::floating_point T>
[[nodiscard]] Solid<T> intersectionOf(const std::vector<Solid<T>>& solids) {
  return detail::intersect<T>(solids);
}

/// The union with a fillet where the two meet, e.g. smoothUnion(a, b, {.reach = 0.1}): larger than
/// the plain one by at most a quarter of the reach (Quadratic), a sixth (Cubic) or 0.3 of it
/// (Circular). Values are lower bounds if the solids' Lipschitz constants are at most 1. With reach
/// 0 these are the plain operators. They are not associative: for more than two solids, use the
/// ...Of forms, whose result does not depend on the order.
/// @throws Error unless the reach is finite and not negative.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> smoothUnion(const A& a, const B& b,
                                             const Smoothing<detail::ScalarOf<A>>& smoothing) {
  return detail::uniteSmoothly<detail::ScalarOf<A>>({a, b}, smoothing);
}
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> smoothIntersection(
    const A& a, const B& b, const Smoothing<detail::ScalarOf<A>>& smoothing) {
  return detail::intersectSmoothly<detail::ScalarOf<A>>({a, b}, smoothing);
}
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> smoothDifference(const A& a, const B& b,
                                                  const Smoothing<detail::ScalarOf<A>>& smoothing) {
  return smoothIntersection(a, ~b, smoothing);
}
/// @throws Error also if the list is empty.
template <std::floating_point T>
[[nodiscard]] Solid<T> smoothUnionOf(const std::vector<Solid<T>>& solids,
                                     const Smoothing<T>& smoothing) {
  return detail::uniteSmoothly<T>(solids, smoothing);
}
template <std::floating_point T>
[[nodiscard]] Solid<T> smoothIntersectionOf(const std::vector<Solid<T>>& solids,
                                            const Smoothing<T>& smoothing) {
  return detail::intersectSmoothly<T>(solids, smoothing);
}

/// The solid grown by a distance, which rounds its convex edges, or shrunk if the distance is
/// negative. Growing keeps exact values outside, shrinking keeps those inside; values on the other
/// side become lower bounds. If the values of `a` are only lower bounds, the result is where they
/// are less than the distance: more is added, or taken away, than by a true offset.
/// @throws Error unless the distance is finite.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> offset(const A& a, detail::ScalarOf<A> distance) {
  return detail::offsetOf<detail::ScalarOf<A>>(a, distance);
}

/// The solid `factor` times as large about the origin, mirrored through it if the factor is
/// negative. Keeps what the solid guarantees. @throws Error unless the factor and its reciprocal
/// are finite.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> scaled(const A& a, detail::ScalarOf<A> factor) {
  return detail::scaledBy<detail::ScalarOf<A>>(a, factor);
}

/// The mirror image in the plane through `point`, with a normal of any length. Keeps what the solid
/// guarantees. Mirroring twice in the same plane gives the original solid.
/// @throws Error unless point and normal are finite and the normal is not zero.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> mirrored(const A& a, const Vec3<detail::ScalarOf<A>>& normal,
                                          const Vec3<detail::ScalarOf<A>>& point = {}) {
  return detail::mirrorOf<detail::ScalarOf<A>>(a, point, normal);
}

/// The image under any invertible affine map: stretched, sheared. Values are lower bounds if the
/// solid's are. Motions, scaled() and mirrored() keep them exact.
/// @throws Error unless the map is finite and its condition number is less than 1 / (64 eps).
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> transformed(const A& a,
                                             const AffineMap<detail::ScalarOf<A>>& map) {
  return detail::affineImageOf<detail::ScalarOf<A>>(a, map);
}

/// A wall around the surface, `halfThickness` to either side. If the solid is exact on both sides,
/// values outside the wall are exact, in the hollow too; within the wall they are lower bounds.
/// @throws Error unless 0 < halfThickness < infinity.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> shell(const A& a, detail::ScalarOf<A> halfThickness) {
  return detail::shellOf<detail::ScalarOf<A>>(a, halfThickness);
}

/// The solid cut at the planes x = 0, y = 0 and z = 0, its parts moved apart by `half` to either
/// side and the gaps filled with the cross-sections: a ball becomes a capsule, a ring a link.
/// Values are lower bounds if the solid's are. @throws Error unless `half` is finite and nowhere
/// negative.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> elongated(const A& a, const Vec3<detail::ScalarOf<A>>& half) {
  return detail::elongationOf<detail::ScalarOf<A>>(a, half);
}

/// A solid between a (t = 0) and b (t = 1): where (1 - t) a + t b is negative. Values are lower
/// bounds if the Lipschitz constants, weighted in the same way, sum to no more than 1.
/// @throws Error unless 0 <= t <= 1.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> blended(const A& a, const B& b, detail::ScalarOf<A> t) {
  return detail::blendOf<detail::ScalarOf<A>>(a, b, t);
}

/// The part on the side that the normal points to, together with its mirror image, at the cost of
/// one query. A lower bound if the solid's value is one; exact outside if the solid is and its
/// bounding box lies on that side, and inside as well if the box does not touch the plane.
/// @throws Error unless point and normal are finite and the normal is not zero.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> folded(const A& a, const Vec3<detail::ScalarOf<A>>& normal,
                                        const Vec3<detail::ScalarOf<A>>& point = {}) {
  return detail::foldOf<detail::ScalarOf<A>>(a, point, normal);
}

/// The whole solid united with its whole mirror image: exact outside, wherever the plane is.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> unfolded(const A& a, const Vec3<detail::ScalarOf<A>>& normal,
                                          const Vec3<detail::ScalarOf<A>>& point = {}) {
  return a | mirrored(a, normal, point);
}

/// The image under inversion in the unit sphere about the origin, p -> p / |p|^2: planes and
/// spheres become spheres. Values are lower bounds if the solid's are. The origin stands for
/// infinity: it is outside if the solid is bounded, and has value 0 otherwise.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> inverted(const A& a) {
  return detail::inversionOf<detail::ScalarOf<A>>(a);
}

/// Copies at multiples of a period along each axis, e.g. repeated(a, {.period = {2, 2, 0}}) for
/// endless rows and columns, or with .count = {3, 4, 1}. Values outside are as good as the solid's;
/// so are those inside if the bounding boxes of neighbours do not overlap, otherwise they are lower
/// bounds. Copies may overlap; each bounding box that is nearer than the nearest copy costs one
/// more query, up to a limit wherever the point is. From far away, values of a solid that are
/// bounds become the distance to its box.
/// @throws Error unless periods are finite and not negative, at least one is positive, the bounding
/// box is finite along repeated axes, and there is one copy along axes of period 0; of kind Limit
/// if more than 10^5 bounding boxes overlap at one point.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> repeated(const A& a, const Repeats<detail::ScalarOf<A>>& repeats) {
  return detail::repetitionOf<detail::ScalarOf<A>>(a, repeats);
}

/// The solid with h(p) added to its value, e.g. for roughness or waves: the surface moves out by
/// about -h. Values are lower bounds if the Lipschitz constants sum to no more than 1; boxes and
/// crossings are certain whatever the constants. The function must not throw, and several threads
/// call it.
///
///     displaced(ball, [](const Vec3<double>& p) { return 0.1 * std::sin(5 * p.x); },
///               {.lipschitz = 0.5, .amplitude = 0.1})
///
/// @throws Error if a limit that is given is negative or not finite.
template <SolidLike A, typename Function>
[[nodiscard]] detail::SolidOf<A> displaced(const A& a, Function h,
                                           const FunctionLimits<detail::ScalarOf<A>>& limits) {
  using T = detail::ScalarOf<A>;
  detail::requireLimits<T>("displaced", limits);
  const auto promise = detail::guaranteeOf<T>(limits, h(Vec3<T>{}));
  return detail::displacementOf<T>(a, FunctionSDF<T, Function>(std::move(h), promise), limits);
}

/// The solid evaluated at p + v(p) instead of p, e.g. bent or twisted: the surface moves by about
/// -v. The Lipschitz constant is multiplied by 1 + limits.lipschitz; values are lower bounds if the
/// product is at most 1, boxes and crossings are certain in any case. The function must not throw,
/// and several threads call it.
///
///     warped(beam, [](const Vec3<double>& p) { return Vec3<double>{0.1 * std::sin(p.z), 0, 0}; },
///            {.lipschitz = 0.1, .amplitude = 0.1})
///
/// @throws Error if a limit that is given is negative or not finite.
template <SolidLike A, typename Function>
[[nodiscard]] detail::SolidOf<A> warped(const A& a, Function v,
                                        const FunctionLimits<detail::ScalarOf<A>>& limits) {
  using T = detail::ScalarOf<A>;
  return detail::warpOf<T>(a, detail::PointShift<T>(std::move(v)), limits);
}

/// A moved copy; shares the geometry.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> translated(const A& a, const Vec3<detail::ScalarOf<A>>& by) {
  detail::SolidOf<A> result = a;
  result.translate(by);
  return result;
}

/// A copy rotated about the coordinate axis 0, 1 or 2 through the origin; shares the geometry.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> rotated(const A& a, detail::ScalarOf<A> degrees, int axis) {
  detail::SolidOf<A> result = a;
  result.rotate(degrees, axis);
  return result;
}

/// A copy rotated about any axis through any point.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> rotated(const A& a, detail::ScalarOf<A> degrees,
                                         const Vec3<detail::ScalarOf<A>>& axis,
                                         const Vec3<detail::ScalarOf<A>>& through = {}) {
  detail::SolidOf<A> result = a;
  result.rotate(degrees, axis, through);
  return result;
}

/// The solid under a name. If all its patches share one name, they take the new one; otherwise each
/// is prefixed with it, as in "mast/shroud". @throws Error if the name is empty.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> named(const A& a, std::string name) {
  return detail::labelled<detail::ScalarOf<A>>(a, std::move(name));
}

}  // namespace cutwater
