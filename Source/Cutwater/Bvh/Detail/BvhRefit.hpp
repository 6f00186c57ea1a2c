#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>

namespace cutwater {

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
