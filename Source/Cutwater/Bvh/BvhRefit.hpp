#pragma once

#include <Cutwater/Bvh/BvhBuilder.hpp>

namespace cutwater {

/// Fits a tree to primitives that have moved: the boxes of all nodes, and the frame of the whole,
/// are computed anew, by the rules of the builder, from `boxes`, which are those of the primitives
/// now, by their ids. Which primitives share a leaf or a node stays, and so do the axes of nodes
/// that were turned: their boxes are fitted to the primitives' boxes.
///
/// Queries are right after any motion, but slow if what was near each other is no longer. Nobody
/// else may use the tree meanwhile. In parallel, by at most so many threads (see ParallelOptions);
/// the result does not depend on their number. Empty and infinite boxes are the caller's to keep
/// out.
/// @throws Error unless there are as many boxes as primitives in the tree.
template <int K, int W>
void refitBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, int threads = 0);

/// The same for triangles: turned boxes are fitted to their corners, which is tighter.
template <int K, int W>
void refitTurnedBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, BvhCorners corners,
                    int threads = 0);

}  // namespace cutwater
