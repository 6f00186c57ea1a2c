#pragma once

#include <algorithm>
#include <concepts>
#include <limits>

namespace cutwater::detail {

/// The largest radius r with r K(r) <= change, where K(r), the most that a function changes per
/// length within the ball of this radius, grows with it; K may be infinite, and jump. To rounding.
///
/// As a function of the ball's centre it is 1-Lipschitz if the change is that function's value: a
/// ball within another one has no larger K.
template <std::floating_point T, typename MostChange>
[[nodiscard]] T largestRadius(const MostChange& mostChange, T change) {
  constexpr T kMost = std::numeric_limits<T>::max();
  if (!(change > 0)) return 0;
  // As far as a ball might reach by what the function changes by within this one.
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
  // reach() falls, and the answer is where it passes below the radius itself: between a radius and
  // its reach. By secants, or halves where these come no nearer, as where it jumps.
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
