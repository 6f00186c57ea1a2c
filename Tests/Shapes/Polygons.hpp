#pragma once

#include <Cutwater/Shapes/Polygon.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

#include "Support/Float128.hpp"

namespace cutwater::test {

template <typename T>
using Loop = std::vector<Vec2<T>>;

template <typename T>
Loop<T> rectangle(T x, T y, T otherX, T otherY) {
  return {{x, y}, {otherX, y}, {otherX, otherY}, {x, otherY}};
}

/// Corners at random distances between `least` and `most` from the centre, in order around it.
template <typename T>
Loop<T> star(const Vec2<double>& center, double least, double most, int corners,
             unsigned seed = 1) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> radius(least, most);
  Loop<T> loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double r = radius(engine);
    loop.push_back({static_cast<T>(center.x + r * std::cos(angle)),
                    static_cast<T>(center.y + r * std::sin(angle))});
  }
  return loop;
}

/// An outline with a notch and a needle, a hole, and an island in it; within [-1, 1]^2.
template <typename T>
Polygon<T> nastyPolygon() {
  const T tip = T(0.875);
  return Polygon<T>({{T(-0.9), T(-0.8)},
                     {T(0.9), T(-0.8)},
                     {T(0.9), T(0.5)},
                     {T(0.4), T(0.5)},
                     {T(0.39), tip},
                     {T(0.38), T(0.5)},
                     {0, T(0.5)},
                     {T(-0.2), T(0.45)},
                     {T(-0.4), T(0.8)},
                     {T(-0.9), T(0.8)}},
                    {rectangle<T>(T(-0.6), T(-0.6), T(0.5), T(0.3)),
                     {{T(-0.25), T(-0.25)}, {T(0.25), T(-0.125)}, {0, T(0.125)}}});
}

/// In quadruple precision, by asking every edge and counting the crossings of a ray.
template <typename T>
double bruteDistance(const Polygon<T>& polygon, const Vec2<T>& p) {
  Float128 least = 1e30;
  bool inside = false;
  for (const auto& loop : polygon.loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& start = loop[i];
      const auto& end = loop[(i + 1) % loop.size()];
      const Float128 x = Float128(end.x) - start.x;
      const Float128 y = Float128(end.y) - start.y;
      const Float128 px = Float128(p.x) - start.x;
      const Float128 py = Float128(p.y) - start.y;
      Float128 along = (px * x + py * y) / (x * x + y * y);
      along = along < 0 ? Float128(0) : along > 1 ? Float128(1) : along;
      const Float128 dx = px - along * x;
      const Float128 dy = py - along * y;
      least = std::min(least, dx * dx + dy * dy);
      if ((start.y <= p.y) == (end.y <= p.y)) continue;
      if (px < x * py / y) inside = !inside;
    }
  }
  const auto distance = static_cast<double>(squareRoot(least));
  return inside ? -distance : distance;
}

}  // namespace cutwater::test
