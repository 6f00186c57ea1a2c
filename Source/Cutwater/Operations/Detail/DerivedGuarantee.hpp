#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <span>

/// Rules that derive a composite's guarantee from those of its operands.
namespace cutwater::detail {

/// What both guarantee: the worse quality on each side, the larger constant and rounding, and the
/// common domain.
template <std::floating_point T>
[[nodiscard]] Guarantee<T> common(const Guarantee<T>& a, const Guarantee<T>& b);

template <std::floating_point T>
[[nodiscard]] Guarantee<T> swapped(Guarantee<T> g);

/// Quality of a function of which only the sign and this Lipschitz constant are known: if the
/// constant is at most 1, the magnitude is a lower bound of the distance.
template <std::floating_point T>
[[nodiscard]] Quality qualityBy(const std::optional<T>& lipschitz) {
  return lipschitz && *lipschitz <= 1 ? Quality::LowerBound : Quality::SignOnly;
}

/// Clearance box of the operands' least or greatest value. For the least, it encloses all their
/// boxes. The greatest is at least as large as each value, so the smallest box will do.
template <std::floating_point T>
[[nodiscard]] Box<T> clearanceBoxOf(std::span<const Solid<T>> operands, bool least);

/// The interval common to two enclosures of the same values.
template <std::floating_point T>
[[nodiscard]] Interval<T> intersection(const Interval<T>& a, const Interval<T>& b) {
  return {a.lower < b.lower ? b.lower : a.lower, a.upper < b.upper ? a.upper : b.upper};
}

}  // namespace cutwater::detail
