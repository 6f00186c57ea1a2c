#pragma once

#include <Cutwater/Core/Repeats.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// The body of a beam between its two nodes.
enum class BeamBody : std::uint8_t {
  ConeSphere,  ///< the convex hull of a ball about each node; `caps` is ignored
  Frustum,     ///< a cone cut off flat at both nodes, to which caps are added
};

/// What is added to a frustum at one of its ends.
enum class BeamCap : std::uint8_t {
  Butt,        ///< nothing: flat
  Hemisphere,  ///< the half of a ball of the end's radius that lies beyond the end
  Sphere,      ///< all of that ball
};

/// Nodes, and straight beams that join them: the input of a BeamLattice. All lengths have the same
/// unit.
struct BeamGraph {
  struct Beam {
    std::array<std::uint32_t, 2> nodes;
    std::array<double, 2> radii;  ///< at each node
    BeamBody body = BeamBody::ConeSphere;
    std::array<BeamCap, 2> caps{BeamCap::Sphere, BeamCap::Sphere};

    bool operator==(const Beam&) const = default;
  };
  /// A ball about a node, with a radius of its own.
  struct Ball {
    std::uint32_t node;  ///< its index in `nodes`
    double radius;       ///< in the unit of length

    bool operator==(const Ball&) const = default;
  };

  /// Positions; beams and balls refer to them by index.
  std::vector<Vec3<double>> nodes;
  std::vector<Beam> beams;
  std::vector<Ball> balls;

  bool operator==(const BeamGraph&) const = default;
};

/// The beams of an array of cells, one for each strut, all with this radius: the same solid as
/// a PeriodicLattice of these cells, which does not store them.
/// @throws Error unless there are cells along each axis, and their sizes are positive and finite;
/// of kind Limit beyond 2^31 beams.
[[nodiscard]] BeamGraph beamsOf(const UnitCell& cell, const Repeats<double>& cells, double radius);

/// The beams and balls of a graph, without those that certainly lie outside a solid, judging by the
/// class of the box around each, and without nodes that are no longer needed.
///
/// The rest has the same intersection with the solid. So a lattice can be clipped to the solid with
/// memory for the remaining beams only:
///
///     BeamLattice<double>(beamsWithin(graph, part)) & part
///
/// There may be no beam left at all. The order is kept.
/// @throws Error if a beam or ball refers to a node that does not exist.
[[nodiscard]] BeamGraph beamsWithin(const BeamGraph& graph, const Solid<double>& solid,
                                    const ParallelOptions& options = {});

}  // namespace cutwater
