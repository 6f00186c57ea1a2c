#pragma once

#include <Cutwater/Surface/MeshReport.hpp>

#include <string>

#include <gtest/gtest.h>

namespace cutwater::test {

/// Two triangles at each edge, that run along it in opposite ways, one fan at each point, and no
/// triangle without area.
inline void expectClosed(const PolygonSoup& soup, const std::string& what) {
  soup.validate();
  const auto report = check(DcelMesh<double>(soup));
  EXPECT_GT(report.faces, 0U) << what;
  EXPECT_EQ(report.boundaryEdges.count, 0U) << what;
  EXPECT_EQ(report.nonManifoldEdges.count, 0U) << what;
  EXPECT_EQ(report.misorientedEdges.count, 0U) << what;
  EXPECT_EQ(report.nonManifoldVertices.count, 0U) << what;
  EXPECT_EQ(report.unusedVertices.count, 0U) << what;
  EXPECT_EQ(report.zeroAreaFaces.count, 0U) << what;
  EXPECT_EQ(report.repeatedCornerFaces.count, 0U) << what;
}

}  // namespace cutwater::test
