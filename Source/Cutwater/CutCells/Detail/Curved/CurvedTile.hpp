#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

namespace cutwater {

/// Whether a box is all fluid or all body for certain, as the value at its center tells.
struct WholeBox {
  bool isWhole = false;
  bool isFluid = false;
};
[[nodiscard]] WholeBox wholeBox(const FluidField& field, const Box<double>& box);

/// The box between the outermost planes.
[[nodiscard]] Box<double> boxOf(const GridPlanes& planes);

/// Cuts the cells between planes.
[[nodiscard]] TileCut cutTile(const FluidField& field, const GridPlanes& planes,
                              const SolidCutterOptions& how, const CutOptions& options);

}  // namespace cutwater
