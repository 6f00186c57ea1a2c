#pragma once

#include <Cutwater/Bvh/BvhTree.hpp>
#include <Cutwater/Mesh/OpenEdges.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// What is known of the triangles below one inner node of a tree, for their winding number from
/// afar: a cache line. In the tree's frame; with x on the triangles, n their unit normals, c the
/// center. Bounds are rounded up, by enough to cover the rounding of everything else.
struct WindingMoments {
  Vec3<float> center;          ///< about the centroid
  float radius;                ///< bound of |x - c|
  Vec3<float> normal;          ///< integral of n
  std::array<float, 5> first;  ///< integral of n (x - c)^T, less its trace: xx, yy, xy + yx, yz +
                               ///< zy, zx + xz; zz = -xx - yy
  float second;                ///< bound of the integral of |x - c|^2
  float area;                  ///< bound of the area
  float openLength;            ///< bound of the open edges' length, each times its multiplicity
  std::uint32_t firstEdge;     ///< of those that belong to leaves of this very node
};
static_assert(sizeof(WindingMoments) == 64);

/// The tree that winding numbers are computed over.
using WindingTree = BvhTree<16, 4>;

struct WindingArrays {
  std::vector<WindingMoments> moments;  ///< of the tree's nodes
  std::vector<OpenEdge> openEdges;      ///< by the node whose leaf holds their triangle
};

/// One pass over the tree, children before their parents; 16 bytes a triangle for the time being,
/// and 64 per node for good, about 1.6 a triangle. The tree's slots are ids of triangles.
template <std::floating_point T>
[[nodiscard]] WindingArrays buildWindingMoments(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const WindingTree& tree);

}  // namespace cutwater
