#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/HexahedralCells.hpp>
#include <Cutwater/Lattice/Thickness.hpp>

namespace cutwater {

/// How struts become beams.
struct StrutOptions {
  /// Parts of equal length in the cell that a strut is made of where it is bent, or its radius is
  /// not linear between its ends; elsewhere it is one beam.
  std::uint32_t subdivisions = 4;
};

/// The beams of unit cells in an array of hexahedra: every strut once, mapped by the trilinear
/// function of the cell that each of its points is in. Of one that reaches beyond its cell the rest
/// is the neighbour's; beyond the ends of the array, that of the last cell's function.
///
/// A beam is straight between two points of the strut, with the radius of the thickness at each. In
/// a regular box, of constant thickness, they are those of beamsOf(cell, Repeats, radius).
///
/// @throws Error unless there is at least one subdivision; of kind Limit beyond 2^31 beams.
[[nodiscard]] BeamGraph beamsOf(const UnitCell& cell, const HexahedralCells& cells,
                                const Thickness<double>& thickness,
                                const StrutOptions& options = {});

}  // namespace cutwater
