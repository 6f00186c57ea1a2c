#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>
#include <Cutwater/Surface/Detail/HoleCaps.hpp>

#include <memory>

namespace cutwater {

/// The surface of a solid by which a CellCutter cuts, and the caps that close its holes, in the
/// world. Throws what that says.
template <std::floating_point T>
[[nodiscard]] std::shared_ptr<const CutSurface> surfaceOf(const Solid<T>& solid, FluidSide side,
                                                          const CutterOptions& options,
                                                          HoleCaps& caps);

extern template std::shared_ptr<const CutSurface> surfaceOf(const Solid<float>&, FluidSide,
                                                            const CutterOptions&, HoleCaps&);
extern template std::shared_ptr<const CutSurface> surfaceOf(const Solid<double>&, FluidSide,
                                                            const CutterOptions&, HoleCaps&);

}  // namespace cutwater
