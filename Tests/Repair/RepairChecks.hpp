#pragma once

#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>

#include <numbers>

#include "Surface/CleanChecks.hpp"

namespace cutwater::test {

inline std::size_t pairsIn(const PolygonSoup& soup) {
  return findSelfIntersections(DcelMesh<double>(soup)).pairs.count;
}

/// Closed, oriented, manifold, of no degenerate faces, and free of self-intersections.
inline void expectSolid(PolygonSoup soup) {
  removeUnusedPoints(soup);
  const auto report = reportOf(soup);
  EXPECT_TRUE(report.isClean()) << report.summary();
  EXPECT_TRUE(report.isManifold()) << report.summary();
  EXPECT_GT(report.volume, 0);
  EXPECT_EQ(pairsIn(soup), 0U);
}

}  // namespace cutwater::test
