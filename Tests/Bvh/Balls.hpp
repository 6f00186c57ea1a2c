#pragma once

#include <Cutwater/Bvh/LinearBVH.hpp>

#include <vector>

#include "Support/Random.hpp"

namespace cutwater::test {

/// A primitive with negative values within it.
template <typename T>
struct Ball {
  Vec3<T> center;
  T radius;

  Box<T> boundingBox() const { return Box<T>{center, center}.grown(radius); }
  T distance(const Vec3<T>& p) const { return length(p - center) - radius; }
  /// Whether the segment comes to within the radius.
  bool crosses(const Segment<T>& segment) const {
    const Vec3<T> way = segment.end - segment.start;
    const T squared = lengthSquared(way);
    const T foot = squared > 0 ? dot(center - segment.start, way) / squared : T(0);
    return distance(segment.at(foot < 0 ? T(0) : foot > 1 ? T(1) : foot)) <= 0;
  }
};

template <typename T>
std::vector<Ball<T>> cloud(int count, T radius, Vec3<T> shift = {}, T scale = 1) {
  RandomPoints<T> random(1);
  std::vector<Ball<T>> balls;
  for (int i = 0; i < count; ++i) {
    balls.push_back({shift + scale * random.next(), scale * radius * (1 + random.next().x / 2)});
  }
  return balls;
}

}  // namespace cutwater::test
