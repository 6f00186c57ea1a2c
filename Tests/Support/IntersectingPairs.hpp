#pragma once

#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

inline void expectSame(const SelfIntersections& a, const SelfIntersections& b) {
  EXPECT_EQ(a.pairs.count, b.pairs.count);
  EXPECT_EQ(a.pairs.examples, b.pairs.examples);
  EXPECT_EQ(a.complete, b.complete);
  EXPECT_EQ(a.skippedTriangles, b.skippedTriangles);
}

/// Every pair by itself; if `changed` is given, those of which one triangle has.
inline SelfIntersections bruteForce(const std::vector<Vec3<double>>& points,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const std::vector<std::uint8_t>& changed = {}) {
  SelfIntersections expected;
  std::vector<bool> flat;
  for (const auto& [a, b, c] : triangles) {
    flat.push_back(!hasArea({points[a], points[b], points[c]}));
    expected.skippedTriangles += flat.back() ? 1U : 0U;
  }
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < triangles.size() && !flat[i]; ++j) {
      if (!changed.empty() && changed[i] == 0 && changed[j] == 0) continue;
      if (flat[j] || !intersect(points, triangles[i], triangles[j])) continue;
      expected.pairs.add({FaceId{i}, FaceId{j}});
    }
  }
  return expected;
}

}  // namespace cutwater::test
