#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <array>
#include <span>

namespace cutwater {

/// The data that queries on a triangle mesh need besides a tree; a view of arrays in a block.
///
/// Positions are those of the mesh times a power of two, so that squares neither over- nor
/// underflow; all points and lengths here are in these units.
template <std::floating_point T>
struct TriangleSurface {
  using Corners = std::array<std::uint32_t, 3>;

  /// The triangle nearest to a point, and what the search has found on the way.
  struct Nearest {
    T distanceSquared = std::numeric_limits<T>::infinity();
    /// kNone if none was near enough, or if a tree's boxes are wrong, which is possible with a
    /// geometry file whose checksums were forged.
    std::uint32_t triangle = kNone;
    /// Bound on the rounding of distances to the point.
    T error = 0;
    /// Any triangle with a squared distance up to this may be the nearest one, given rounding.
    T tie = std::numeric_limits<T>::max();
    // Smallest squared distances of the triangles that have the point behind, in and in front of
    // their plane, as decided by exact tests.
    T behind = tie;
    T inPlane = tie;
    T before = tie;

    /// The value of `tie` if the nearest triangle has this squared distance: both distances may be
    /// off by the error.
    [[nodiscard]] CUTWATER_INLINE T tieAt(T squared) const {
      const T reach = squareRoot(squared) + 2 * error;
      return reach * reach;
    }
    /// `side`: the sign of the triangle's orientation() with respect to the point.
    CUTWATER_INLINE void noteSide(T squared, int side) {
      T& least = side < 0 ? behind : side == 0 ? inPlane : before;
      least = squared < least ? squared : least;
    }
    /// Lets a triangle compete: the nearest wins, among equally near ones the lowest id.
    CUTWATER_INLINE void offer(T squared, std::uint32_t id, int side) {
      noteSide(squared, side);
      if (squared > distanceSquared || (squared == distanceSquared && id > triangle)) return;
      distanceSquared = squared;
      triangle = id;
      tie = tieAt(squared);
    }

    /// The side of the point if all triangles that may be the nearest agree on it: 1 outside, -1
    /// inside; else 0.
    ///
    /// A result other than 0 is certain. All triangles at the closest point are among them, and the
    /// pseudonormal there, a sum of their normals with positive weights, has the point on that side
    /// (Baerentzen and Aanaes 2005, "Signed distance computation using the angle weighted
    /// pseudonormal"). The feature to which the closest point belongs, a matter of rounding, is not
    /// used.
    [[nodiscard]] int agreedSide() const {
      const bool isBehind = behind <= tie;
      const bool isBefore = before <= tie;
      if (inPlane <= tie || isBehind == isBefore) return 0;
      return isBefore ? 1 : -1;
    }

   private:
    CUTWATER_INLINE static float squareRoot(float x) { return __builtin_sqrtf(x); }
    CUTWATER_INLINE static double squareRoot(double x) { return __builtin_sqrt(x); }
  };

  /// The scaled positions of the vertices, and each triangle's corners as indices of these.
  std::span<const Vec3<T>> positions;
  std::span<const Corners> triangles;
  std::span<const Corners> neighbours;      ///< triangles across AB, BC, CA; kNone where open
  std::span<const std::uint32_t> slivers;   ///< one bit per triangle
  std::span<const Vec3<T>> pseudonormals;   ///< per vertex
  std::span<const std::uint32_t> polygons;  ///< per triangle: the face it is part of
  std::span<const std::uint32_t> patches;   ///< per polygon
  T scale = 1;                              ///< position here = scale * position of the mesh
  T size = 0;                               ///< length of the longest corner's position vector
  Box<double> box;                          ///< of all corners of triangles

  /// A triangle by its id, in the precision of the surface, and in double.
  [[nodiscard]] Triangle<T> triangle(std::uint32_t id) const {
    const auto& v = triangles[id];
    return {positions[v[0]], positions[v[1]], positions[v[2]],
            (slivers[id / 32] >> id % 32 & 1U) != 0};
  }
  [[nodiscard]] std::array<Vec3<double>, 3> corners(std::uint32_t id) const {
    const auto& v = triangles[id];
    return {Vec3<double>(positions[v[0]]), Vec3<double>(positions[v[1]]),
            Vec3<double>(positions[v[2]])};
  }

  /// The owner of a triangle; unknown for kNone.
  [[nodiscard]] SurfaceOwner owner(std::uint32_t id) const {
    if (id == kNone) return {};
    return {.object = 0, .patch = patches[polygons[id]], .face = polygons[id]};
  }

  /// The start of a search: no triangle yet.
  [[nodiscard]] Nearest nothing(const Vec3<T>& p) const {
    Nearest result;
    result.error = error(p);
    return result;
  }
  /// Lets triangles compete with the best so far. Ids end at the first kNone.
  void compete(const Vec3<T>& p, std::span<const std::uint32_t> ids, Nearest& best) const;

  /// The sign of the pseudonormal of the nearest feature, as computed: 1 outside, -1 inside. At
  /// sharp edges and where sheets are close, only agreedSide() or locate() is certain.
  [[nodiscard]] int pseudonormalSide(const Vec3<T>& p, const Nearest& nearest) const;

  /// Everything about the nearest point except the distance, in the mesh's own units.
  [[nodiscard]] SurfacePoint<T> surfacePoint(const Vec3<T>& p, const Nearest& nearest) const;

  /// Bound on the rounding error of a distance at `p`: 8 eps (|p| + |V|max).
  [[nodiscard]] T error(const Vec3<T>& p) const {
    return 8 * std::numeric_limits<T>::epsilon() * (length(p) + size);
  }

 private:
  /// Unit length for faces; edges and vertices only up to a positive factor.
  [[nodiscard]] Vec3<T> pseudonormal(std::uint32_t id, TrianglePart part) const;
};

extern template struct TriangleSurface<float>;
extern template struct TriangleSurface<double>;

}  // namespace cutwater
