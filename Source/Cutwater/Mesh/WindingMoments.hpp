#pragma once

#include <Cutwater/Bvh/BvhTree.hpp>
#include <Cutwater/Mesh/OpenEdges.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The tree that winding numbers are computed over.
using WindingTree = BvhTree<16, 4>;

/// What is known of the triangles below each lane of a node, leaf or node, for their winding number
/// from afar. In the tree's frame; with x on the triangles, n their unit normals, c the center.
/// Bounds are rounded up, by enough to cover the rounding of what they are compared with.
struct alignas(64) WindingMoments {
  using Lanes = BvhNode<WindingTree::kArity>::Lanes;

  std::array<Lanes, 3> center;  ///< about the centroid
  Lanes radius;                 ///< bound of |x - c|
  std::array<Lanes, 3> normal;  ///< integral of n
  std::array<Lanes, 5> first;   ///< integral of n (x - c)^T, less its trace: xx, yy, xy + yx,
                                ///< yz + zy, zx + xz; zz = -xx - yy
  Lanes second;                 ///< bound of the integral of |x - c|^2
  Lanes area;                   ///< bound of the area
};

/// The open edges below a node.
struct WindingEdges {
  float length;         ///< bound of the sum of their lengths, each times its multiplicity
  std::uint32_t first;  ///< of those that belong to leaves of this very node
};

/// What WindingNumber keeps beside the tree.
struct WindingArrays {
  std::vector<WindingMoments> moments;  ///< per node of the tree
  std::vector<WindingEdges> edges;      ///< per node of the tree
  std::vector<OpenEdge> openEdges;      ///< by the node whose leaf holds their triangle
};

/// One pass over the tree, children before their parents. 904 bytes a node, about 23 a triangle.
/// The tree's slots are ids of triangles.
template <std::floating_point T>
[[nodiscard]] WindingArrays buildWindingMoments(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const WindingTree& tree);

}  // namespace cutwater
