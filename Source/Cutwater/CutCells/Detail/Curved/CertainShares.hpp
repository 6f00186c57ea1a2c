#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

namespace cutwater {

/// @throws Error(Argument) unless this is a number of the precision of the field's solid.
void requireInPrecision(const FluidField& field, double plane);

/// See SolidCutter::certified().
[[nodiscard]] CertifiedCells certifiedCells(const FluidField& field, const CutCells& cells,
                                            const CertifyOptions& options);

}  // namespace cutwater
