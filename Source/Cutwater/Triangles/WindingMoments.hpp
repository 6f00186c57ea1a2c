#pragma once

#include <Cutwater/Bvh/Detail/BvhTree.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The tree that winding numbers are computed over.
using WindingTree = BvhTree<16, 4>;

/// Moments of the triangles below each lane of a node (a leaf or a node), from which their winding
/// number is computed from afar. In the tree's frame, with x on the triangles, n their unit normals
/// and c the center. Bounds are rounded up, by enough to cover the rounding of what they are
/// compared with.
struct alignas(64) WindingMoments {
  using Lanes = BvhNode<WindingTree::kArity>::Lanes;

  std::array<Lanes, 3> center;  ///< approximately the centroid
  Lanes radius;                 ///< bound on |x - c|
  std::array<Lanes, 3> normal;  ///< integral of n
  std::array<Lanes, 5> first;   ///< integral of n (x - c)^T, less its trace: xx, yy, xy + yx,
                                ///< yz + zy, zx + xz; zz = -xx - yy
  Lanes second;                 ///< bound on the integral of |x - c|^2
  Lanes area;                   ///< bound on the area
};

/// The open edges below a node.
struct WindingEdges {
  float length;         ///< bound on the sum of their lengths, each times its multiplicity
  std::uint32_t first;  ///< index of the first that belongs to a leaf of this very node
};

/// The arrays of a WindingNumber besides the tree.
struct WindingArrays {
  std::vector<WindingMoments> moments;  ///< per node of the tree
  std::vector<WindingEdges> edges;      ///< per node of the tree
  std::vector<OpenEdge> openEdges;      ///< by the node whose leaf holds their triangle
};

/// Takes one pass over the tree, children before their parents, and 904 bytes per node, about 23
/// per triangle. The tree's slots are ids of triangles.
template <std::floating_point T>
[[nodiscard]] WindingArrays buildWindingMoments(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const WindingTree& tree);

}  // namespace cutwater
