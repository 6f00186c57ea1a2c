#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>

namespace cutwater::detail {

/// A function with its gradient.
template <std::floating_point T>
struct Slopes {
  FunctionRef<T(const Vec3<T>&)> value;
  FunctionRef<Vec3<T>(const Vec3<T>&)> gradient;
  Guarantee<T> guarantee;
};

/// Encloses the least value in a box, by a few projected steps against the gradient, whose lengths
/// follow from the change of the gradient in the step before (J. Barzilai and J. Borwein,
/// "Two-point step size gradient methods", IMA J. Numer. Anal. 8, 1988). The upper end is the
/// lowest of the values computed on the way, at places in the box up to its slack. The lower end is
/// proven, and -infinity without `concavity`.
///
/// Let f + k |p|^2 / 2 be convex in the box, where k is `concavity`. Then f lies above its tangent
/// plane at any point q of it, less that term:
///
///     f(p) >= f(q) + grad f(q) . (p - q) - k |p - q|^2 / 2
///
/// whose least value in the box is that of one of its corners, axis by axis. The lower end is the
/// best of these, minus what rounding may change: see kRoundings. For a convex function, both ends
/// meet at the minimum. Where k is more than 1 over the box's radius, the term exceeds all that
/// could be gained, and nothing is proven.
template <std::floating_point T>
[[nodiscard]] Interval<T> leastIn(const Slopes<T>& slopes, const OrientedBox<T>& box, T atCenter,
                                  std::optional<T> concavity);

}  // namespace cutwater::detail
