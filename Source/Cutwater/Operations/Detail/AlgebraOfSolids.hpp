#pragma once

#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Core/Repeats.hpp>
#include <Cutwater/Operations/Smoothing.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <string>
#include <vector>

/// What the operators of Algebra.hpp do, on Solids. Out of line, so that a user's file parses no
/// operator it does not use.
namespace cutwater::detail {

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
[[nodiscard]] Solid<T> warpOf(Solid<T> a, PointShift<T> v, const FunctionLimits<T>& limits);
template <std::floating_point T>
[[nodiscard]] Solid<T> labelled(Solid<T> a, std::string name);

// The types that they are templates over.
template <typename A>
using ScalarOf = typename A::Scalar;
template <typename A>
using SolidOf = Solid<ScalarOf<A>>;

template <typename A, typename B>
concept SameScalar = std::same_as<ScalarOf<A>, ScalarOf<B>>;

}  // namespace cutwater::detail
