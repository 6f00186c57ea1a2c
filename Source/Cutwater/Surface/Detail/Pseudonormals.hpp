#pragma once

#include <Cutwater/Surface/MeshRanges.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// Normals of a triangle mesh for which dot(p - c, n) has the sign of the distance, where c is the
/// point closest to p, be it in a triangle, on an edge or at a vertex.
///
/// J. A. Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted
/// pseudonormal", IEEE Trans. Vis. Comput. Graph. 11 (2005). All are unit vectors, or zero where
/// nothing but rounding is left of the sum; triangles without area contribute nothing.
template <std::floating_point T>
struct Pseudonormals {
  std::vector<Vec3<T>> triangles;
  std::vector<Vec3<T>> vertices;  ///< sums of triangle normals times angles

  /// The normal of the edge between two triangles: the direction of the sum of their normals.
  static Vec3<T> edge(const Vec3<T>& one, const Vec3<T>& other);
};

/// Computes them in linear time, in parallel, in double with one rounding at the end. Gives the
/// same bits for any number of threads, on one type of CPU (atan2).
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
