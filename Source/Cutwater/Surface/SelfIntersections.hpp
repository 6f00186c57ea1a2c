#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/MeshReport.hpp>

#include <array>
#include <span>

namespace cutwater {

/// Two faces of a mesh, or the same face twice; first <= second.
struct FacePair {
  FaceId first;
  FaceId second;
  bool operator==(const FacePair&) const = default;
};

/// Where a surface meets itself.
struct SelfIntersections {
  /// Pairs of faces that meet in more than the vertices and edges they share; touching counts, and
  /// so do duplicates. The examples are the first pairs in ascending order.
  Findings<FacePair> pairs;
  bool complete = true;              ///< false: stopped at the limit, the count is a lower bound
  std::size_t skippedTriangles = 0;  ///< those without area

  /// Whether there are any.
  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(pairs); }
};

/// Options of findSelfIntersections().
struct SelfIntersectionOptions {
  /// Counting ends at this many pairs (there may be as many as the number of faces squared), but
  /// not before the examples are complete.
  std::size_t limit = 1'000'000;
  /// At most this many threads; 0: all available. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Looks for pairs of triangles that meet at a point that is not on a vertex or an edge that they
/// share. Corners are shared if they have the same index: weld first. Every pair is decided
/// exactly, see TriangleIntersection.hpp; the result does not depend on the number of threads.
///
/// The faces in the result are indices of triangles. Takes about as long as building the tree, plus
/// the time for pairs of triangles whose boxes meet; where these are very many, as in fans and
/// among slivers, triangles are first divided by planes, so that the time stays near linear.
/// @throws Error(Argument) if a corner is not the index of a position, or a position is not finite.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const SelfIntersectionOptions& options = {});

/// The same for polygons as triangulated, see DcelMesh::triangles(): two faces count once, however
/// many of their triangles meet, and a face whose own triangles meet counts as a pair with itself.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(const DcelMesh<T>& mesh,
                                                      const SelfIntersectionOptions& options = {});

}  // namespace cutwater
