#pragma once

#include <Cutwater/Bvh/Detail/BvhTree.hpp>
#include <Cutwater/Core/FunctionRef.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The arrays of a newly built tree.
template <int K, int W>
struct BvhArrays {
  BvhFrame frame;
  std::vector<BvhNode<K>> nodes;
  std::vector<std::uint32_t> slots;
  int depth = 0;  ///< of the deepest node, counted from 1

  /// A view of the arrays, which must outlive it.
  [[nodiscard]] BvhTree<K, W> tree() const { return {frame, nodes, slots, depth}; }
};

/// Builds a tree over the boxes; slot ids are indices into them. Deterministic: the result depends
/// only on the boxes. The caller must exclude empty and infinite boxes. Runs in parallel on at most
/// `threads` threads (see ParallelOptions).
///
/// Makes binary splits by the surface area heuristic with 16 bins (Wald 2007, "On fast construction
/// of SAH-based bounding volume hierarchies"), near the leaves by a sorted sweep at multiples of W,
/// so that leaves are full. Then collapses them to K children by dynamic programming, minimising
/// the summed area of all nodes (Ylitie, Karras and Laine 2017, "Efficient incoherent ray traversal
/// on GPUs through compressed wide BVHs", section 3).
/// @throws Error(Limit) for more than 2^32 - 2 boxes.
template <int K, int W>
[[nodiscard]] BvhArrays<K, W> buildBvh(std::span<const Box<double>> boxes, int threads = 0);

/// Returns the corners of a triangle.
using BvhCorners = FunctionRef<std::array<Vec3<double>, 3>(std::uint32_t)>;

/// The same over triangles: the boxes of each node are in a frame turned to fit the triangles,
/// where that makes them smaller.
template <int K, int W>
[[nodiscard]] BvhArrays<K, W> buildTurnedBvh(std::span<const Box<double>> boxes, BvhCorners corners,
                                             int threads = 0);

/// Fits a tree to primitives that have moved. Recomputes the boxes of all nodes and the tree's
/// frame, by the rules of the builder, from `boxes`: the current boxes of the primitives, indexed
/// by id. The grouping of primitives into leaves and nodes is kept, and so are the axes of turned
/// nodes, whose boxes are fitted to the boxes of the primitives.
///
/// Queries are correct after any motion, but slow if primitives that were close together no longer
/// are. No other thread may use the tree during the call. Runs in parallel on at most `threads`
/// threads (see ParallelOptions); the result does not depend on their number. The caller must
/// exclude empty and infinite boxes. @throws Error unless there are as many boxes as primitives in
/// the tree.
template <int K, int W>
void refitBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, int threads = 0);

/// The same for triangles: turned boxes are fitted to the triangles' corners, which is tighter.
template <int K, int W>
void refitTurnedBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, BvhCorners corners,
                    int threads = 0);

}  // namespace cutwater
