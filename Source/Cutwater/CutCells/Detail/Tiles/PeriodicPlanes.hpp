#pragma once

#include <Cutwater/CutCells/Detail/Tiles/CutBlocks.hpp>

namespace cutwater {

/// See CellCutter::cellsOfPeriod().
[[nodiscard]] CellPlanes planesOfPeriod(const CutPeriod& period,
                                        const std::array<std::vector<double>, 3>& planes,
                                        const Index3& first, const IndexBox& box);
/// The planes of a grid patch, which lie as exactly whole periods apart along axes with a period.
template <std::floating_point T>
[[nodiscard]] CellPlanes planesOf(const CutPeriod& period, const GridPatch<T>& gridPatch);

/// The cells of a grid and around it, where they are cut, in this frame.
/// @throws Error(Argument) unless they have the period, as planesOfPeriod() gives it.
[[nodiscard]] CutBlocks::Stretches stretchesOf(const CellPlanes& grid, const CutPeriod& period,
                                               const CutFrame& frame = {});

extern template CellPlanes planesOf(const CutPeriod&, const GridPatch<float>&);
extern template CellPlanes planesOf(const CutPeriod&, const GridPatch<double>&);

}  // namespace cutwater
