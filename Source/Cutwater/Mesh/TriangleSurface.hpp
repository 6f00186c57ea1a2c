#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/DcelMesh.hpp>
#include <Cutwater/Mesh/TriangleDistance.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater {

/// What queries on a closed triangle mesh need besides a tree; a view of arrays in a block.
///
/// Positions are those of the mesh times a power of two, so that squares neither over- nor
/// underflow; all points and lengths here are in these units.
template <std::floating_point T>
struct TriangleSurface {
  using Corners = std::array<std::uint32_t, 3>;

  /// The triangle nearest to a point.
  struct Nearest {
    TriangleHit<T> hit;
    std::uint32_t triangle = kNone;
  };

  std::span<const Vec3<T>> positions;
  std::span<const Corners> triangles;
  std::span<const Corners> neighbours;      ///< triangles across AB, BC, CA
  std::span<const std::uint32_t> slivers;   ///< one bit per triangle
  std::span<const Vec3<T>> pseudonormals;   ///< per vertex
  std::span<const std::uint32_t> polygons;  ///< per triangle: the face it is part of
  std::span<const std::uint32_t> patches;   ///< per polygon
  T scale = 1;                              ///< position here = scale * position of the mesh
  T size = 0;                               ///< length of the longest position vector

  [[nodiscard]] Triangle<T> triangle(std::uint32_t id) const {
    const auto& v = triangles[id];
    return {positions[v[0]], positions[v[1]], positions[v[2]],
            (slivers[id / 32] >> id % 32 & 1U) != 0};
  }

  /// Lets triangles compete with the best so far; the nearest wins, of equals the lowest id. Ids
  /// end at the first kNone.
  void compete(const Vec3<T>& p, std::span<const std::uint32_t> ids, Nearest& best) const;

  /// Distance with the sign of the pseudonormal of the nearest feature (Baerentzen and Aanaes 2005,
  /// "Signed distance computation using the angle weighted pseudonormal"); 0 on the surface.
  [[nodiscard]] T signedDistance(const Vec3<T>& p, const Nearest& nearest) const;

  /// Everything about the nearest point, in the mesh's own units.
  [[nodiscard]] SurfacePoint<T> surfacePoint(const Vec3<T>& p, const Nearest& nearest) const;

  /// Bound on the rounding of a distance at `p`: 8 eps (|p| + |V|max).
  [[nodiscard]] T error(const Vec3<T>& p) const {
    return 8 * std::numeric_limits<T>::epsilon() * (length(p) + size);
  }

 private:
  [[nodiscard]] Vec3<T> pseudonormal(const Nearest& nearest) const;
};

/// The arrays of a TriangleSurface, fresh from a mesh.
template <std::floating_point T>
class TriangleSurfaceData {
 public:
  /// Faces of more than three corners are triangulated, those of no area and fewer than three
  /// distinct corners left out. Shells that are inside out are turned (see Shells.hpp).
  /// @throws Error(Topology) unless the rest is closed and consistently oriented.
  explicit TriangleSurfaceData(const DcelMesh<T>& mesh);

  /// Where the arrays will lie in the block.
  struct Sections {
    Section positions, triangles, neighbours, slivers, pseudonormals, polygons, patches;
    T scale = 1;
    T size = 0;

    [[nodiscard]] TriangleSurface<T> view(const Block& block) const;
  };
  [[nodiscard]] Sections addTo(BlockWriter& writer) const;

  [[nodiscard]] std::vector<Box<double>> triangleBoxes() const;
  [[nodiscard]] std::size_t turnedShells() const { return turnedShells_; }

 private:
  using Corners = typename TriangleSurface<T>::Corners;

  void take(const DcelMesh<T>& triangles);
  void markSlivers();

  std::vector<Vec3<T>> positions_;
  std::vector<Corners> triangles_;
  std::vector<Corners> neighbours_;
  std::vector<std::uint32_t> slivers_;
  std::vector<Vec3<T>> pseudonormals_;
  std::vector<std::uint32_t> polygons_;
  std::vector<std::uint32_t> patches_;
  T scale_ = 1;
  T size_ = 0;
  std::size_t turnedShells_ = 0;
};

extern template struct TriangleSurface<float>;
extern template struct TriangleSurface<double>;
extern template class TriangleSurfaceData<float>;
extern template class TriangleSurfaceData<double>;

}  // namespace cutwater
