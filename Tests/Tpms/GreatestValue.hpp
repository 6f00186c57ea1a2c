#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace cutwater::test {

/// The greatest value of f in the cell lies within [found, bound], by branch and bound, if f has
/// this Lipschitz constant per radian.
template <typename F>
Interval<double> greatest(const F& f, double lipschitz, double gap) {
  struct Cube {
    double most;
    Vec3<double> center;
    double half;
    bool operator<(const Cube& other) const { return most < other.most; }
  };
  std::priority_queue<Cube> pending;
  double found = -1e300;
  const auto add = [&](const Vec3<double>& center, double half) {
    const double value = f(center);
    found = std::max(found, value);
    pending.push({value + lipschitz * std::sqrt(3) * half * (2 * std::numbers::pi), center, half});
  };
  add({0.5, 0.5, 0.5}, 0.5);
  while (pending.top().most > found + gap) {
    const auto cube = pending.top();
    pending.pop();
    for (int i = 0; i < 8; ++i) {
      const double h = cube.half / 2;
      add(cube.center +
              Vec3<double>{(i & 1) != 0 ? h : -h, (i & 2) != 0 ? h : -h, (i & 4) != 0 ? h : -h},
          h);
    }
  }
  return {found, pending.top().most};
}

}  // namespace cutwater::test
