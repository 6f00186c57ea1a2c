#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The triangles of a leaf in single precision, component by component: a search looks at these
/// before it evaluates in full the few triangles that may be the nearest.
///
/// Lengths are in the tree's frame. Unused lanes repeat the last triangle.
struct alignas(64) TrianglePacket {
  static constexpr int kWidth = 16;
  using Lanes = std::array<float, kWidth>;

  std::array<Lanes, 3> a;  ///< relative to `center`
  std::array<Lanes, 3> ab;
  std::array<Lanes, 3> ac;
  std::array<Lanes, 3> normal;  ///< of unit length; 0 without area
  Vec3<float> center;
  float radius = 0;                        ///< no corner is farther from the centre
  std::array<std::uint32_t, 12> unused{};  ///< pads the cache line with equal bytes

  /// Returns the triangle that the rounded numbers represent.
  [[nodiscard]] std::array<Vec3<double>, 3> corners(std::size_t lane) const;
};

/// The tree of a triangle mesh.
using TriangleTree = BvhTree<16, TrianglePacket::kWidth>;
using TriangleTreeArrays = BvhArrays<TriangleTree::kArity, TriangleTree::kLeafWidth>;

/// Builds the tree over the boxes of the triangles, whose corners are indices of positions.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays buildTriangleTree(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the tree with the same triangles in every leaf, refitted to vertices that have moved.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays refittedTriangleTree(
    const TriangleTree& tree, std::span<const Vec3<T>> positions,
    std::span<const std::array<std::uint32_t, 3>> triangles);

/// Packs triangles, at most as many as a packet has lanes.
[[nodiscard]] TrianglePacket packTriangles(std::span<const std::array<Vec3<double>, 3>> triangles);

/// One packet for each leaf of the tree.
template <std::floating_point T>
[[nodiscard]] std::vector<TrianglePacket> packTriangles(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree);

}  // namespace cutwater
