#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// The beams and balls of a graph, without those that certainly lie outside a solid, judging by the
/// class of the box around each, and without nodes that are no longer needed.
///
/// What is left has the same points in common with the solid. A lattice can thus be clipped by it
/// with no more memory than the remaining part takes:
///
///     BeamLattice<double>(beamsWithin(graph, part)) & part
///
/// There may be no beam left at all. The order is kept.
/// @throws Error if a beam or ball refers to a node that does not exist.
[[nodiscard]] BeamGraph beamsWithin(const BeamGraph& graph, const Solid<double>& solid,
                                    const ParallelOptions& options = {});

}  // namespace cutwater
