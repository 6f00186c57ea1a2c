#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Commands/Commands.hpp"
#include "Commands/Picture.hpp"
#include "Options/CuttingOptions.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Options/SampleGrid.hpp"
#include "Report/Format.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct SliceSettings {
  SurfaceOptions surface;
  PictureOptions picture;
  GridRequest grid;  // of cells, if a picture of them is wanted
  CuttingOptions cutting;

  [[nodiscard]] bool isOfCells() const {
    return !grid.cells.empty() || !grid.spacing.empty() || grid.total.has_value();
  }
  [[nodiscard]] bool saysWhichCells() const {
    return cutting.areGiven() || grid.box || grid.margin;
  }
};

/// The cells along an axis that meet a range; of none, the last is below the first.
struct CellRange {
  std::int32_t first, last;
};
CellRange cellsIn(const GridPatch<double>& grid, int axis, double lower, double upper) {
  const double origin = grid.level.cell({0, 0, 0}).lower[axis];
  const double width = grid.level.spacing()[axis];
  const auto count = static_cast<double>(grid.indices.length(axis));
  const double first = std::max(std::floor((lower - origin) / width), 0.0);
  const double last = std::min(std::ceil((upper - origin) / width), count) - 1;
  return {static_cast<std::int32_t>(std::min(first, count)),
          static_cast<std::int32_t>(std::max(last, -1.0))};
}

/// The layer of cells with this place; of two that meet there, the upper one.
std::optional<std::int32_t> layerAt(const GridPatch<double>& grid, int axis, double at) {
  const double origin = grid.level.cell({0, 0, 0}).lower[axis];
  const double layer = std::floor((at - origin) / grid.level.spacing()[axis]);
  if (!(layer >= 0 && layer < static_cast<double>(grid.indices.length(axis)))) return {};
  return static_cast<std::int32_t>(layer);
}

void setRange(IndexBox& box, int axis, const CellRange& range) {
  (axis == 0 ? box.lo.i : axis == 1 ? box.lo.j : box.lo.k) = range.first;
  (axis == 0 ? box.hi.i : axis == 1 ? box.hi.j : box.hi.k) = range.last;
}

/// The layer of cells at the place that is asked for, as far as it is shown.
GridPatch<double> shownCells(const SliceSettings& options, const Solid<double>& solid) {
  const auto& picture = options.picture;
  const auto box = boxAround(solid);
  auto grid = gridAround(box, options.grid);
  const double at = picture.at.value_or(box.center()[picture.axis]);
  const auto all = grid;
  const auto layer = layerAt(all, picture.axis, at);
  if (!layer) {
    throw Error(ErrorKind::Argument, "there are no cells where " +
                                         std::string(1, "xyz"[picture.axis]) + " = " + number(at) +
                                         ": --box or --margin makes the grid larger");
  }
  setRange(grid.indices, picture.axis, {*layer, *layer});
  if (picture.slice.window) {
    const int right = picture.axis == 0 ? 1 : 0;
    const int up = picture.axis == 2 ? 1 : 2;
    const auto& [lower, upper] = *picture.slice.window;
    setRange(grid.indices, right, cellsIn(all, right, lower[0], upper[0]));
    setRange(grid.indices, up, cellsIn(all, up, lower[1], upper[1]));
  }
  if (grid.indices.empty()) {
    throw Error(ErrorKind::Argument,
                "there are no cells in the window: --box or --margin makes "
                "the grid larger");
  }
  return grid;
}

/// @throws Error(Limit) if there are more cells than pixels.
void requirePixels(const SliceSettings& options, const IndexBox& cells) {
  const int axis = options.picture.axis;
  const auto right = cells.length(axis == 0 ? 1 : 0);
  const auto up = cells.length(axis == 2 ? 1 : 2);
  const auto& slice = options.picture.slice;
  if (right <= static_cast<std::size_t>(slice.width) &&
      up <= static_cast<std::size_t>(slice.height)) {
    return;
  }
  throw Error(ErrorKind::Limit, "a picture of " + std::to_string(slice.width) + " x " +
                                    std::to_string(slice.height) + " pixels cannot show " +
                                    grouped(right) + " x " + grouped(up) +
                                    " cells: show some of them by --window, or use fewer");
}

void reportCells(const SliceSettings& options, const CutCells& cells, double seconds) {
  std::size_t several = 0;
  std::size_t thin = 0;
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const auto& first = cells.cells.firstPiece;
    if (first[row + 1] > first[row] + 1) ++several;
    if (cells.cells.isThin(row)) ++thin;
  }
  const auto layer = cells.boxOf(cells.grid.first);
  const int axis = options.picture.axis;
  std::cout << "wrote " << onOneLine(options.picture.output) << ": " << options.picture.slice.width
            << " x " << options.picture.slice.height << " pixels of the cells from "
            << "xyz"[axis] << " = " << number(layer.lower[axis]) << " to "
            << number(layer.upper[axis]) << ", in " << duration(seconds) << '\n';
  std::cout << grouped(cells.cellCount) << " of " << grouped(cells.grid.indices().count())
            << " are cut; " << grouped(several) << " have several pieces, and in " << grouped(thin)
            << " all corners are on one side\n";
}

void drawCells(const SliceSettings& options, const Solid<double>& solid) {
  static_cast<void>(cuttingMesh(solid, options.surface));
  const auto& [output, axis, at, slice] = options.picture;
  const auto grid = shownCells(options, solid);
  requirePixels(options, grid.indices);
  const CellCutter cutter(solid, options.cutting.side(), options.cutting.cutter);
  Stopwatch watch;
  const auto cells = [&] {
    ProgressBar bar("cutting", !options.surface.quiet);
    return cutter.cut(
        grid, {.polygons = true, .threads = options.surface.threads, .progress = bar.callback()});
  }();
  const auto layer = cells.boxOf(cells.grid.first);
  CellSliceOptions shown{.window = slice.window,
                         .width = slice.width,
                         .height = slice.height,
                         .title = slice.title,
                         .unit = slice.unit};
  if (shown.title.empty()) {
    const double part = 1e-3 * layer.size()[axis];  // more digits say nothing
    shown.title = fileName(options.surface) + ", " + "xyz"[axis] + " = " +
                  number(part * std::round(layer.center()[axis] / part) + 0.0, 4) +
                  (slice.unit.empty() ? "" : " " + slice.unit);
  }
  const auto index = axis == 0   ? cells.grid.first.i
                     : axis == 1 ? cells.grid.first.j
                                 : cells.grid.first.k;
  writePng(output, renderCells(cells, axis, index, shown));
  if (!options.surface.quiet) reportCells(options, cells, watch.lap());
}

void run(const SliceSettings& options) {
  if (!options.isOfCells() && options.saysWhichCells()) {
    throw Error(ErrorKind::Argument,
                "--inside, --open, --baffle, --cap-holes, --period, --box and --margin are for a "
                "picture of cells: with --cells, --spacing or --total");
  }
  const auto solid = loadSolid(options.surface);
  if (options.isOfCells()) {
    drawCells(options, solid);
  } else {
    writePicture(solid, options.surface, options.picture);
  }
}

}  // namespace

void addSlice(Program& program) {
  const auto options = std::make_shared<SliceSettings>();
  auto command = program.addCommand("slice",
                                    "Draw the signed distance in a plane with the surface's "
                                    "outline, or a layer of cut cells, as a PNG picture");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->picture.output, {".png"}, "The picture to write")
      .required();
  addPictureOptions(command, options->picture);
  addSizeOptions(command, options->grid, "no cells, but the signed distance");
  addPlaceOptions(command, options->grid);
  addCuttingOptions(command, options->cutting);
  command.setFooter(
      "Examples:\n"
      "  cutwater slice hull.stl -o hull.png\n"
      "  cutwater slice hull.stl --axis z --at 0.2 --unit m --title \"Waterline\" -o water.png\n"
      "  cutwater slice part.stl --scale 0.001 --window -0.1,0,0.1,0.05 --size 2400x1200 -o "
      "detail.png\n"
      "  cutwater slice hull.stl --spacing 0.02 --window 5.6,0,6.1,0.3 -o cells.png");
  command.setAction([=] {
    passOn(options->cutting, options->grid, options->surface);
    run(*options);
  });
}

}  // namespace cutwater::tool
