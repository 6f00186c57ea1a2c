#pragma once

#include <Cutwater/Bvh/BvhBuilder.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The triangles of a leaf in single precision, component by component: what a search looks at
/// before it evaluates the few that may be the nearest in full.
///
/// Lengths are those of the tree's frame. Unused lanes repeat the last triangle.
struct alignas(64) TrianglePacket {
  static constexpr int kWidth = 16;
  using Lanes = std::array<float, kWidth>;

  std::array<Lanes, 3> a;  ///< relative to `center`
  std::array<Lanes, 3> ab;
  std::array<Lanes, 3> ac;
  std::array<Lanes, 3> normal;  ///< of unit length; 0 without area
  Vec3<float> center;
  float radius = 0;                        ///< all corners are within it of the centre
  std::array<std::uint32_t, 12> unused{};  ///< to the end of the cache line: equal bytes

  /// Of the triangle that the rounded numbers stand for.
  [[nodiscard]] std::array<Vec3<double>, 3> corners(std::size_t lane) const;
};

/// The tree of a triangle mesh.
using TriangleTree = BvhTree<16, TrianglePacket::kWidth>;
using TriangleTreeArrays = BvhArrays<TriangleTree::kArity, TriangleTree::kLeafWidth>;

/// Builds it over the boxes of the triangles; their corners are indices of positions.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays buildTriangleTree(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// The tree, with the same triangles in every leaf, around vertices that have moved.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays refittedTriangleTree(
    const TriangleTree& tree, std::span<const Vec3<T>> positions,
    std::span<const std::array<std::uint32_t, 3>> triangles);

/// At most as many as a packet has lanes.
[[nodiscard]] TrianglePacket packTriangles(std::span<const std::array<Vec3<double>, 3>> triangles);

/// One packet for each leaf of the tree.
template <std::floating_point T>
[[nodiscard]] std::vector<TrianglePacket> packTriangles(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree);

}  // namespace cutwater
