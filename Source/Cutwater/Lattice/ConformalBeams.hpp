#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/HexahedralCells.hpp>
#include <Cutwater/Lattice/Thickness.hpp>

namespace cutwater {

/// Options for turning struts into beams.
struct StrutOptions {
  /// The number of parts, of equal length in the cell, into which a strut is divided if it is bent
  /// or its radius is not linear between its ends; otherwise it is one beam.
  std::uint32_t subdivisions = 4;
};

/// The beams of unit cells in an array of hexahedra: every strut once, each of its points mapped by
/// the trilinear function of the cell that the point is in. The part of a strut that reaches beyond
/// its cell is mapped by the neighbour's function, and beyond the ends of the array by the last
/// cell's.
///
/// A beam is straight between two points of the strut, and its radius at each follows from the
/// thickness. In a regular box and with constant thickness, beams are those of beamsOf(cell,
/// Repeats, radius).
///
/// @throws Error unless there is at least one subdivision; of kind Limit beyond 2^31 beams.
[[nodiscard]] BeamGraph beamsOf(const UnitCell& cell, const HexahedralCells& cells,
                                const Thickness<double>& thickness,
                                const StrutOptions& options = {});

}  // namespace cutwater
