#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <vector>

namespace cutwater::test {

/// Points between two, as many and as close together as searches share leaves of a tree for.
template <typename T>
std::vector<Vec3<T>> brickBetween(const Vec3<T>& p, const Vec3<T>& q) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 128; ++i) {
    const Vec3<T> part{T(i % 8) / 64, T(i / 8 % 4) / 64, T(i / 32) / 64};
    points.push_back(
        {p.x + part.x * (q.x - p.x), p.y + part.y * (q.y - p.y), p.z + part.z * (q.z - p.z)});
  }
  return points;
}

}  // namespace cutwater::test
