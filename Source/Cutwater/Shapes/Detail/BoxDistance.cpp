#include <Cutwater/Shapes/Detail/BoxDistance.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
T boxDistance(const Box<T>& box, const Vec3<T>& p) {
  const Vec3<T> d = max(box.lower - p, p - box.upper);
  const T deepest = maxComponent(d);
  return deepest < 0 ? deepest : length(max(d, Vec3<T>{}));
}

template <std::floating_point T>
Interval<T> boxDistances(const Box<T>& box, const Box<T>& range) {
  const Vec3<T> middle = box.center();
  Vec3<T> nearest;
  Vec3<T> farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const T lower = range.lower[axis];
    const T upper = range.upper[axis];
    nearest[axis] = std::clamp(middle[axis], lower, upper);
    farthest[axis] = middle[axis] - lower > upper - middle[axis] ? lower : upper;
  }
  return {boxDistance(box, nearest), boxDistance(box, farthest)};
}

template <std::floating_point T>
Vec3<T> boxGradient(const Box<T>& box, const Vec3<T>& p) {
  const Vec3<T> below = box.lower - p;
  const Vec3<T> above = p - box.upper;
  const Vec3<T> d = max(below, above);
  const T deepest = maxComponent(d);
  if (deepest > 0) return normalized(max(above, Vec3<T>{}) - max(below, Vec3<T>{}));

  Vec3<T> gradient;
  int nearestFaces = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (below[axis] == deepest) gradient[axis] -= 1, ++nearestFaces;
    if (above[axis] == deepest) gradient[axis] += 1, ++nearestFaces;
  }
  return nearestFaces == 1 ? gradient : Vec3<T>{};
}

template float boxDistance(const Box<float>&, const Vec3<float>&);
template double boxDistance(const Box<double>&, const Vec3<double>&);
template Interval<float> boxDistances(const Box<float>&, const Box<float>&);
template Interval<double> boxDistances(const Box<double>&, const Box<double>&);
template Vec3<float> boxGradient(const Box<float>&, const Vec3<float>&);
template Vec3<double> boxGradient(const Box<double>&, const Vec3<double>&);

}  // namespace cutwater::detail
