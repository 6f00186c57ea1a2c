#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// The beams and balls of a graph without those that certainly lie outside of a solid, as the class
/// of the box around each tells, and without nodes that are not needed any more.
///
/// What is left has the same points in common with the solid: a lattice is clipped by it at the
/// memory of the part that stays,
///
///     BeamLattice<double>(beamsWithin(graph, part)) & part
///
/// and there may be no beam at all. The order is kept.
/// @throws Error if a beam or ball has no such node.
[[nodiscard]] BeamGraph beamsWithin(const BeamGraph& graph, const Solid<double>& solid,
                                    const ParallelOptions& options = {});

}  // namespace cutwater
