#pragma once

#include <Cutwater/Bvh/Detail/FittingAxes.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

namespace cutwater {

/// The triangles of a leaf in single precision, component by component: a search looks at these
/// before it evaluates in full the few triangles that may be the nearest.
///
/// Lengths are in the tree's frame. Unused lanes repeat the last triangle.
struct alignas(64) TrianglePacket {
  static constexpr int kWidth = TriangleTree::kLeafWidth;
  using Lanes = std::array<float, kWidth>;

  std::array<Lanes, 3> a;  ///< relative to `center`
  std::array<Lanes, 3> ab;
  std::array<Lanes, 3> ac;
  std::array<Lanes, 3> normal;  ///< of unit length; 0 without area
  Vec3<float> center;
  float radius = 0;  ///< no corner is farther from the centre
  /// A box around them has this centre, and these half extents along its axes.
  detail::BoxAxes axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3<float> half;

  /// Returns the triangle that the rounded numbers represent.
  [[nodiscard]] std::array<Vec3<double>, 3> corners(std::size_t lane) const;
};

/// Packs triangles, at most as many as a packet has lanes.
[[nodiscard]] TrianglePacket packTriangles(std::span<const std::array<Vec3<double>, 3>> triangles);

/// One packet for each leaf of the tree.
template <std::floating_point T>
[[nodiscard]] std::vector<TrianglePacket> packTriangles(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree);

}  // namespace cutwater
