#pragma once

#include <Cutwater/Core/Level.hpp>

#include <optional>
#include <string>
#include <vector>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// The options that describe the grid around a surface. At most one of cells, total and spacing.
struct GridRequest {
  /// One number: cubes, this many along the longest side. Three: cells along each axis.
  std::vector<std::int32_t> cells;
  std::optional<double> total;  ///< cubes, about this many in all
  /// One number or three: sides of a cell.
  std::vector<double> spacing;
  std::optional<Box<double>> box;
  std::optional<double> margin;  ///< around the surface, if there is no box
  Vec3<double> period = {};      ///< what the grid spans along each axis, whole cells; 0: see box
  bool nodes = false;            ///< values at nodes, not at cell centres
};

/// The grid that covers the box, or the surface and a margin of a tenth of its diagonal. Cells
/// whose size is given keep it: the box grows to whole cells, about its centre. Along an axis with
/// a period, the grid lies about the surface's centre unless there is a box, and other cells are
/// stretched.
/// @throws Error(Argument) if the surface has no extent, and for a box or cells that do not fit a
/// period; Error(Limit) if the grid is too large.
[[nodiscard]] GridPatch<double> gridAround(const Box<double>& surface, const GridRequest& request);

/// The size of cells that are so many times as wide, as an option that fits: "--spacing 0.02 fits".
[[nodiscard]] std::string sizeThatFits(const GridPatch<double>& grid, double factor);

/// The same of a grid that spans periods: "--cells 20x10x20 fits".
[[nodiscard]] std::string numberThatFits(const GridPatch<double>& grid, double factor);

/// Small blocks of indices all over a grid, from which the time for all of it is estimated.
[[nodiscard]] std::vector<IndexBox> blocksOf(const IndexBox& grid);

/// Adds --cells, --spacing and --total. `grid` must outlive the command. `otherwise`: what there is
/// without any of them.
void addSizeOptions(Command command, GridRequest& grid, const std::string& otherwise = "128");
/// Adds --box and --margin, likewise.
void addPlaceOptions(Command command, GridRequest& grid);

}  // namespace cutwater::tool
