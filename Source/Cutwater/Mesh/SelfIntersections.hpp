#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/TrianglePackets.hpp>

#include <array>
#include <span>

namespace cutwater {

/// Two faces of a mesh, or twice the same; first <= second.
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
  bool complete = true;              ///< false: stopped at the limit, there are at least so many
  std::size_t skippedTriangles = 0;  ///< those without area

  /// There are some.
  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(pairs); }
};

/// Options of findSelfIntersections().
struct SelfIntersectionOptions {
  /// Counting ends at this many pairs (there may be as many as faces squared), but not before the
  /// examples are complete.
  std::size_t limit = 1'000'000;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Looks for pairs of triangles that meet in a point of no vertex and no edge that they share.
/// Corners are shared if they have the same number: weld first. Every pair is decided exactly, see
/// TriangleIntersection.hpp; the result does not depend on the number of threads.
///
/// The faces of the result are numbers of triangles. Time: about that of building the tree, plus
/// that for every pair of triangles whose boxes meet.
/// @throws Error(Argument) if a corner is no position or not finite.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const SelfIntersectionOptions& options = {});

/// With a tree over the bounding boxes of these triangles, in the units of the positions.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree, const SelfIntersectionOptions& options = {});

/// Polygons as triangulated, see DcelMesh::triangles(): two faces count once, however many of their
/// triangles meet, and one whose own triangles meet counts as a pair of its own.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(const DcelMesh<T>& mesh,
                                                      const SelfIntersectionOptions& options = {});

}  // namespace cutwater
