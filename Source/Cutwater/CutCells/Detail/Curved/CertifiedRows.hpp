#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <span>

namespace cutwater {

/// @throws Error(Argument) unless this is a number of the precision of the field's solid.
void requireInPrecision(const FluidField& field, double plane);

/// See SolidCutter::certified(). `period`: of the field.
[[nodiscard]] CertifiedCells certifiedCells(const FluidField& field, const CutCells& cells,
                                            const CutPeriod& period, const CertifyOptions& options);
/// The same of leaves; `boxes`: of all leaves.
[[nodiscard]] CertifiedLeaves certifiedLeaves(const FluidField& field, const CutLeaves& leaves,
                                              std::span<const Box<double>> boxes,
                                              const CertifyOptions& options);

}  // namespace cutwater
