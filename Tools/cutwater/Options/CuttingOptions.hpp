#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>

#include <optional>

#include "Options/Command.hpp"
#include "Options/MeshOptions.hpp"
#include "Options/SurfaceOptions.hpp"

namespace cutwater::tool {

/// What commands that cut cells are told of the surface.
struct CuttingOptions {
  bool isInside = false;
  CutterOptions cutter;
  std::optional<double> tolerance;  ///< of a solid that is no surface

  [[nodiscard]] FluidSide side() const { return isInside ? FluidSide::Inside : FluidSide::Outside; }
  [[nodiscard]] bool hasPeriod() const { return cutter.period != Vec3<double>{}; }
  /// Whether any of them was given.
  [[nodiscard]] bool areGiven() const {
    return isInside || tolerance || hasPeriod() || areOfSurface();
  }
  /// Any of those that only surfaces have.
  [[nodiscard]] bool areOfSurface() const;
};

/// Adds --inside, --open, --baffle, --cap-holes, --period and --tolerance. `options` must outlive
/// the command.
void addCuttingOptions(Command command, CuttingOptions& options);

/// Adds those that describe an octree to a command with --cells, --spacing and --total; returns
/// --level, which all others need. `options` must outlive the command.
Option addOctreeOptions(Command command, MeshOptions& options);

/// @throws Error(Argument) for what octrees do not know.
void refuseOnOctrees(const CuttingOptions& options);

/// Tells the grid and the surface what they must know of these options.
/// @throws Error(Argument) for those that exclude each other.
void passOn(const CuttingOptions& options, GridRequest& grid, SurfaceOptions& surface);

}  // namespace cutwater::tool
