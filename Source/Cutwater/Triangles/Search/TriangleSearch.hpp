#pragma once

#include <Cutwater/Triangles/Search/ChildHulls.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

namespace cutwater {

/// The triangles of a surface by plain pointers: all that code compiled once per instruction set
/// may touch, as functions of TriangleSurface or std::span would be shared with code for older
/// processors.
template <std::floating_point T>
struct KernelTriangles {
  const Vec3<T>* positions;
  const std::uint32_t* corners;  ///< three for each triangle
  const std::uint32_t* slivers;  ///< one bit per triangle

  explicit KernelTriangles(const TriangleSurface<T>& surface)
      : positions(surface.positions.data()),
        corners(surface.triangles.data()->data()),
        slivers(surface.slivers.data()) {}

  /// The triangle with this id.
  [[nodiscard]] CUTWATER_INLINE Triangle<T> triangle(std::uint32_t id) const {
    const std::uint32_t* const v = corners + 3 * std::size_t{id};
    return {positions[v[0]], positions[v[1]], positions[v[2]],
            (slivers[id / 32] >> id % 32 & 1U) != 0};
  }
  /// The triangle's point that is nearest to `p`.
  [[nodiscard]] Vec3<T> closestPoint(std::uint32_t id, const Vec3<T>& p) const;
};

/// The data that the search for the nearest triangle of a surface reads; a view of arrays in a
/// block.
///
/// Whole loops are compiled for each instruction set, from one source: TriangleSearch.inl.
struct TriangleSearch {
  const BvhNode<16>* nodes = nullptr;
  const std::uint32_t* slots = nullptr;
  const TrianglePacket* packets = nullptr;
  const ChildHulls* hulls = nullptr;
  const std::uint32_t* hullsOfNode = nullptr;  ///< null: there are none
  BvhFrame frame;
  bool isSmall = false;  ///< stays in a processor's second-level cache

  TriangleSearch() = default;
  TriangleSearch(const TriangleTree& tree, std::span<const TrianglePacket> leaves,
                 std::span<const ChildHulls> childHulls, std::span<const std::uint32_t> ofNode);

  /// Considers all triangles that may be the nearest to `p`, or tie with it within rounding, if
  /// that is within `reach`. `best` starts as surface.nothing(p), or as what is known already.
  template <std::floating_point T>
  void nearest(const TriangleSurface<T>& surface, const Vec3<T>& p,
               typename TriangleSurface<T>::Nearest& best, double reach = kAnywhere) const;
  static constexpr double kAnywhere = 0x1p62;

  /// The same for many points, each with its own element of `bests`. Neighbours in the span should
  /// be close to each other in space.
  template <std::floating_point T>
  void nearest(const TriangleSurface<T>& surface, std::span<const Vec3<T>> points,
               std::span<typename TriangleSurface<T>::Nearest> bests) const;
  /// The same where that is within `reach`; elsewhere any triangle or none. Fast if most points
  /// have none.
  template <std::floating_point T>
  void nearest(const TriangleSurface<T>& surface, std::span<const Vec3<T>> points,
               std::span<typename TriangleSurface<T>::Nearest> bests, double reach) const;
};

}  // namespace cutwater
