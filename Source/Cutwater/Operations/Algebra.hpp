#pragma once

#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Operations/Detail/Displacement.hpp>
#include <Cutwater/Operations/Detail/Repetition.hpp>
#include <Cutwater/Operations/Detail/Warp.hpp>
#include <Cutwater/Operations/SmoothMinimum.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <string>
#include <vector>

/// Operators and functions that combine solids: they take shapes and Solids alike and return
/// Solids.
///
///     const auto body = rounded(hull, 0.1) | translated(mast, {2, 0, 0}) - hatch;
///
/// `-` binds tighter than `&`, `&` tighter than `^`, and `^` tighter than `|`.
namespace cutwater {

namespace detail {

// Work on Solids; out of line, so that a user's file parses no operator it does not use.
template <std::floating_point T>
[[nodiscard]] Solid<T> unite(const std::vector<Solid<T>>& operands);
template <std::floating_point T>
[[nodiscard]] Solid<T> intersect(const std::vector<Solid<T>>& operands);
template <std::floating_point T>
[[nodiscard]] Solid<T> complementOf(Solid<T> a);
template <std::floating_point T>
[[nodiscard]] Solid<T> xorOf(Solid<T> a, Solid<T> b);
template <std::floating_point T>
[[nodiscard]] Solid<T> uniteSmoothly(const std::vector<Solid<T>>& operands,
                                     const Smoothing<T>& smoothing);
template <std::floating_point T>
[[nodiscard]] Solid<T> intersectSmoothly(const std::vector<Solid<T>>& operands,
                                         const Smoothing<T>& smoothing);
template <std::floating_point T>
[[nodiscard]] Solid<T> offsetOf(const Solid<T>& a, T distance);
template <std::floating_point T>
[[nodiscard]] Solid<T> scaledBy(Solid<T> a, T factor);
template <std::floating_point T>
[[nodiscard]] Solid<T> mirrorOf(Solid<T> a, const Vec3<T>& point, const Vec3<T>& normal);
template <std::floating_point T>
[[nodiscard]] Solid<T> affineImageOf(Solid<T> a, const AffineMap<T>& map);
template <std::floating_point T>
[[nodiscard]] Solid<T> shellOf(Solid<T> a, T halfThickness);
template <std::floating_point T>
[[nodiscard]] Solid<T> elongationOf(Solid<T> a, const Vec3<T>& half);
template <std::floating_point T>
[[nodiscard]] Solid<T> blendOf(Solid<T> a, Solid<T> b, T t);
template <std::floating_point T>
[[nodiscard]] Solid<T> foldOf(Solid<T> a, const Vec3<T>& point, const Vec3<T>& normal);
template <std::floating_point T>
[[nodiscard]] Solid<T> inversionOf(const Solid<T>& a);
template <std::floating_point T>
[[nodiscard]] Solid<T> repetitionOf(Solid<T> a, const Repeats<T>& repeats);
template <std::floating_point T>
[[nodiscard]] Solid<T> displacementOf(Solid<T> a, Solid<T> h, const FunctionLimits<T>& limits);
template <std::floating_point T>
[[nodiscard]] Solid<T> labelled(Solid<T> a, std::string name);

template <typename A>
using ScalarOf = typename A::Scalar;
template <typename A>
using SolidOf = Solid<ScalarOf<A>>;

template <typename A, typename B>
concept SameScalar = std::same_as<ScalarOf<A>, ScalarOf<B>>;

}  // namespace detail

/// All points of a or b. A union of unions is one union with all their operands, in order.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator|(const A& a, const B& b) {
  return detail::unite<detail::ScalarOf<A>>({a, b});
}

/// All points common to a and b. An intersection of intersections is one intersection, likewise.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> operator&(const A& a, const B& b) {
  return detail::intersect<detail::ScalarOf<A>>({a, b});
}

/// All points that are not in a.
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

/// All points of a or b, but not of both; see SymmetricDifference.
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

/// The union with a fillet where the two meet, e.g. smoothUnion(a, b, {.reach = 0.1}); see
/// SmoothCombination. With reach 0 these are the plain operators. They are not associative: for
/// more than two solids, use the ...Of forms, whose result does not depend on the order.
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

/// The solid grown by a distance, or shrunk if it is negative; see Offset.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> offset(const A& a, detail::ScalarOf<A> distance) {
  return detail::offsetOf<detail::ScalarOf<A>>(a, distance);
}

/// The same, under its usual name in modelling: growing rounds the edges with this radius.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> rounded(const A& a, detail::ScalarOf<A> radius) {
  return offset(a, radius);
}

/// The solid `factor` times as large about the origin; see Scale.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> scaled(const A& a, detail::ScalarOf<A> factor) {
  return detail::scaledBy<detail::ScalarOf<A>>(a, factor);
}

/// The mirror image in the plane through `point`; see Mirror. Mirroring twice in the same plane
/// gives the original solid.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> mirrored(const A& a, const Vec3<detail::ScalarOf<A>>& normal,
                                          const Vec3<detail::ScalarOf<A>>& point = {}) {
  return detail::mirrorOf<detail::ScalarOf<A>>(a, point, normal);
}

/// The image under any invertible affine map; see Affine.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> transformed(const A& a,
                                             const AffineMap<detail::ScalarOf<A>>& map) {
  return detail::affineImageOf<detail::ScalarOf<A>>(a, map);
}

/// A wall around the surface, `halfThickness` to either side; see Shell.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> shell(const A& a, detail::ScalarOf<A> halfThickness) {
  return detail::shellOf<detail::ScalarOf<A>>(a, halfThickness);
}

/// The solid drawn out by `half` to either side of the origin along each axis; see Elongation.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> elongated(const A& a, const Vec3<detail::ScalarOf<A>>& half) {
  return detail::elongationOf<detail::ScalarOf<A>>(a, half);
}

/// A solid between a (t = 0) and b (t = 1): (1 - t) a + t b; see Blend.
template <SolidLike A, SolidLike B>
requires detail::SameScalar<A, B>
[[nodiscard]] detail::SolidOf<A> blended(const A& a, const B& b, detail::ScalarOf<A> t) {
  return detail::blendOf<detail::ScalarOf<A>>(a, b, t);
}

/// The part on the side that the normal points to, together with its mirror image; see Fold.
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

/// The image under inversion in the unit sphere about the origin; see Inversion.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> inverted(const A& a) {
  return detail::inversionOf<detail::ScalarOf<A>>(a);
}

/// Copies at multiples of a period along each axis, e.g. repeated(a, {.period = {2, 2, 0}}) for
/// endless rows and columns, or with .count = {3, 4, 1}; see Repetition.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> repeated(const A& a, const Repeats<detail::ScalarOf<A>>& repeats) {
  return detail::repetitionOf<detail::ScalarOf<A>>(a, repeats);
}

/// The solid with h(p) added to its value; see Displacement.
///
///     displaced(ball, [](const Vec3<double>& p) { return 0.1 * std::sin(5 * p.x); },
///               {.lipschitz = 0.5, .amplitude = 0.1})
///
/// @throws Error unless the limits are finite or none, and not negative.
template <SolidLike A, typename Function>
[[nodiscard]] detail::SolidOf<A> displaced(const A& a, Function h,
                                           const FunctionLimits<detail::ScalarOf<A>>& limits) {
  using T = detail::ScalarOf<A>;
  detail::requireLimits<T>("displaced", limits);
  const auto promise = detail::guaranteeOf<T>(limits, h(Vec3<T>{}));
  return detail::displacementOf<T>(a, FunctionSDF<T, Function>(std::move(h), promise), limits);
}

/// The solid evaluated at p + v(p) instead of p; see Warp.
///
///     warped(beam, [](const Vec3<double>& p) { return Vec3<double>{0.1 * std::sin(p.z), 0, 0}; },
///            {.lipschitz = 0.1, .amplitude = 0.1})
///
/// @throws Error unless the limits are finite or none, and not negative.
template <SolidLike A, typename Function>
[[nodiscard]] detail::SolidOf<A> warped(const A& a, Function v,
                                        const FunctionLimits<detail::ScalarOf<A>>& limits) {
  return WarpBy<detail::ScalarOf<A>, Function>(a, std::move(v), limits);
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

/// The solid with its patches named; see Labelled.
template <SolidLike A>
[[nodiscard]] detail::SolidOf<A> named(const A& a, std::string name) {
  return detail::labelled<detail::ScalarOf<A>>(a, std::move(name));
}

}  // namespace cutwater
