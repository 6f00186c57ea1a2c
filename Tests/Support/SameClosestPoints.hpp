#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Grid.hpp"

namespace cutwater::test {

/// The same bits; any NaN is equal to any other.
template <std::floating_point T>
bool isSame(T a, T b) {
  return sameBits(a, b) || (std::isnan(a) && std::isnan(b));
}

template <std::floating_point T>
bool isSame(const Vec3<T>& a, const Vec3<T>& b) {
  return isSame(a.x, b.x) && isSame(a.y, b.y) && isSame(a.z, b.z);
}

/// Names of the fields that differ; none if the answers are the same to the bit.
template <std::floating_point T>
std::string differingFields(const SurfacePoint<T>& a, const SurfacePoint<T>& b) {
  std::string names;
  const auto compare = [&](const char* name, bool same) {
    if (!same) names += std::string(names.empty() ? "" : ", ") + name;
  };
  compare("point", isSame(a.point, b.point));
  compare("normal", isSame(a.normal, b.normal));
  compare("distance", isSame(a.distance, b.distance));
  compare("tolerance", isSame(a.tolerance, b.tolerance));
  compare("exact", a.exact == b.exact);
  compare("feature", a.feature == b.feature);
  compare("owner", a.owner == b.owner);
  compare("triangle", a.triangle == b.triangle);
  compare("barycentric", isSame(a.barycentric, b.barycentric));
  return names;
}

/// Expects closestPoints() to answer as closestPoint() does, at the points and at some that are not
/// finite among them.
template <std::floating_point T>
void expectSameClosestPoints(const SignedDistanceFunction<T>& function,
                             std::vector<Vec3<T>> points) {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2),
                {{1, kInf, 0}, {kNaN, 0, 1}, {0, 1, -kInf}});
  std::vector<SurfacePoint<T>> alone;
  for (const auto& p : points) alone.push_back(function.closestPoint(p));
  for (const int threads : {1, 2}) {
    std::vector<SurfacePoint<T>> together(points.size());
    function.closestPoints(points, together, {.threads = threads});
    int wrong = 0;
    for (std::size_t i = 0; i < points.size() && wrong < 3; ++i) {
      const auto differing = differingFields(alone[i], together[i]);
      EXPECT_EQ(differing, "") << "at " << points[i] << ", " << threads << " threads";
      wrong += !differing.empty();
    }
  }
}

}  // namespace cutwater::test
