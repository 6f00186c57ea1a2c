#pragma once

#include <array>

#include "Peers/ClosestPoint.hpp"
#include "Peers/Peers.hpp"

namespace cutwater::benchmarks {

/// The sign that peers leave to their users: by the angle-weighted pseudonormal of the feature on
/// which the closest point lies (J. A. Baerentzen, H. Aanaes, IEEE Trans. Vis. Comput. Graph. 11,
/// 2005).
class PseudonormalSign {
 public:
  explicit PseudonormalSign(const PolygonSoup& triangles);

  /// The closest point's distance with the sign of its side.
  [[nodiscard]] double signedDistance(std::size_t triangle, const ClosestPoint& closest) const {
    const double distance = length(closest.offset);
    return dot(closest.offset, normal(triangle, closest.part)) < 0 ? -distance : distance;
  }

 private:
  using Normals = std::array<Vec3<double>, 3>;

  [[nodiscard]] const Vec3<double>& normal(std::size_t triangle, Part part) const {
    if (part == kFace) return faces_[triangle];
    if (part >= kEdgeAB) return edges_[triangle][part - kEdgeAB];
    return vertices_[corners_[3 * triangle + part]];
  }
  void setFaces(const PolygonSoup& triangles);
  void setVertices(const PolygonSoup& triangles);
  void setEdges();

  std::vector<std::uint32_t> corners_;
  std::vector<Vec3<double>> faces_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Normals> edges_;
};

/// The soup's triangles with their coordinates.
[[nodiscard]] std::vector<Corners> cornersOf(const PolygonSoup& triangles);

}  // namespace cutwater::benchmarks
