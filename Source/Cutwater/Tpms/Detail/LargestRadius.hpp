#pragma once

#include <algorithm>
#include <concepts>
#include <limits>

namespace cutwater::detail {

/// The largest radius r with r K(r) <= change, up to rounding. K(r) is the most that a function
/// changes per length within the ball of radius r; it grows with r, may be infinite, and may jump.
///
/// As a function of the ball's centre, the radius is 1-Lipschitz if `change` is that function's
/// value: a ball inside another one has no larger K.
template <std::floating_point T, typename MostChange>
[[nodiscard]] T largestRadius(const MostChange& mostChange, T change) {
  constexpr T kMost = std::numeric_limits<T>::max();
  if (!(change > 0)) return 0;
  // How far a ball could reach at the rate of change within this one.
  const auto reach = [&](T radius) {
    const T most = mostChange(radius);
    return most <= kMost ? change / most : T(0);
  };
  T low = 0;
  T reachOfLow = reach(low);
  if (!(reachOfLow > 0 && reachOfLow <= kMost)) return reachOfLow > 0 ? kMost : T(0);
  T high = reachOfLow;
  T reachOfHigh = reach(high);
  if (reachOfHigh >= high) return high;
  // reach() decreases, and the result is where it falls below the radius itself: between a radius
  // and its reach. Found by secants, or by halving where these make no progress, e.g. at a jump.
  constexpr int kMostSteps = 200;
  bool isSlow = false;
  for (int step = 0; step < kMostSteps; ++step) {
    const T width = high - low;
    if (width <= 2 * std::numeric_limits<T>::epsilon() * high) break;
    const T above = reachOfLow - low;
    T next = low + width * (isSlow ? T(0.5) : above / (above + (high - reachOfHigh)));
    if (!(next > low && next < high)) next = low + width / 2;
    if (!(next > low && next < high)) break;
    const T reached = reach(next);
    if (reached >= next) {
      low = next;
      reachOfLow = reached;
      high = std::min(high, reached);
    } else {
      high = next;
      reachOfHigh = reached;
      low = std::max(low, reached);
    }
    isSlow = high - low > width / 2;
  }
  return low;
}

}  // namespace cutwater::detail
