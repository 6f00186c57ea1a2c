#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <span>

/// Rules by which a composite's guarantee follows from those of its operands.
namespace cutwater::detail {

/// What both promise: the worse quality on each side, the larger constant and rounding, the common
/// domain.
template <std::floating_point T>
[[nodiscard]] Guarantee<T> common(const Guarantee<T>& a, const Guarantee<T>& b);

template <std::floating_point T>
[[nodiscard]] Guarantee<T> swapped(Guarantee<T> g);

/// What the magnitude of a function means that is only known to have the right sign and this
/// Lipschitz constant: of at most 1 it is a lower bound of the distance.
template <std::floating_point T>
[[nodiscard]] Quality qualityBy(const std::optional<T>& lipschitz) {
  return lipschitz && *lipschitz <= 1 ? Quality::LowerBound : Quality::SignOnly;
}

/// Of the least of functions with these as operands: all of their boxes. The greatest is at least
/// any one of them: the smallest box.
template <std::floating_point T>
[[nodiscard]] Box<T> clearanceBoxOf(std::span<const Solid<T>> operands, bool least);

/// What two enclosures of the same values say together.
template <std::floating_point T>
[[nodiscard]] Interval<T> intersection(const Interval<T>& a, const Interval<T>& b) {
  return {a.lower < b.lower ? b.lower : a.lower, a.upper < b.upper ? a.upper : b.upper};
}

}  // namespace cutwater::detail
