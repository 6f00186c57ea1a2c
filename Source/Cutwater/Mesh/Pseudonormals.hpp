#pragma once

#include <Cutwater/Mesh/MeshRanges.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// Normals of a triangle mesh with which dot(p - c, n) has the sign of the distance, for c the
/// closest point of p, whether in a triangle, on an edge or at a vertex.
///
/// J. A. Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted
/// pseudonormal", IEEE Trans. Vis. Comput. Graph. 11 (2005). All are unit vectors, or zero where
/// only rounding is left of the sum; triangles of no area contribute nothing.
template <std::floating_point T>
struct Pseudonormals {
  std::vector<Vec3<T>> triangles;
  std::vector<Vec3<T>> vertices;  ///< sums of triangle normals times angles

  /// Of the edge between two triangles: the direction of the sum of their normals.
  static Vec3<T> edge(const Vec3<T>& one, const Vec3<T>& other);
};

/// In linear time, in parallel; computed in double and rounded once. The same bits whatever the
/// number of threads, on one type of CPU (atan2).
template <std::floating_point T>
[[nodiscard]] Pseudonormals<T> pseudonormals(std::span<const Vec3<T>> points,
                                             std::span<const TriangleCorners> triangles);

extern template struct Pseudonormals<float>;
extern template struct Pseudonormals<double>;
extern template Pseudonormals<float> pseudonormals(std::span<const Vec3<float>>,
                                                   std::span<const TriangleCorners>);
extern template Pseudonormals<double> pseudonormals(std::span<const Vec3<double>>,
                                                    std::span<const TriangleCorners>);

}  // namespace cutwater
