#include <Cutwater/Core/Error.hpp>
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
#include "Options/Cutter.hpp"
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
  GridRequest grid;    // of cells, if a picture of them is wanted
  MeshOptions octree;  // the same of leaves, but for place
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

/// What a picture shows, for people.
struct Shown {
  std::string where;  ///< as in "from x = 1 to 2"
  std::size_t cells = 0;
  std::size_t cut = 0;
  std::size_t several = 0;
  std::size_t thin = 0;
};

void report(const SliceSettings& options, const Shown& shown, double seconds) {
  const auto& slice = options.picture.slice;
  std::cout << "wrote " << onOneLine(options.picture.output) << ": " << slice.width << " x "
            << slice.height << " pixels of the cells " << shown.where << ", in "
            << duration(seconds) << '\n';
  std::cout << grouped(shown.cut) << " of " << grouped(shown.cells) << " are cut; "
            << grouped(shown.several) << " have several pieces, and in " << grouped(shown.thin)
            << " all corners are on one side\n";
}

/// Without the cells around the box.
template <typename Rows>
void count(const Rows& rows, std::size_t cut, Shown& shown) {
  shown.cut = cut;
  for (std::size_t row = 0; row < cut; ++row) {
    if (rows.firstPiece[row + 1] > rows.firstPiece[row] + 1) ++shown.several;
    if (rows.isThin(row)) ++shown.thin;
  }
}

void reportCells(const SliceSettings& options, const CutCells& cells, double seconds) {
  const auto layer = cells.boxOf(cells.grid.first);
  const int axis = options.picture.axis;
  Shown shown{.where = std::string("from ") + "xyz"[axis] + " = " + number(layer.lower[axis]) +
                       " to " + number(layer.upper[axis]),
              .cells = cells.grid.indices().count()};
  count(cells.cells, cells.cellCount, shown);
  report(options, shown, seconds);
}

/// How to draw them: `at`, the plane's place, and the thickness of its cells.
CellSliceOptions lookOf(const SliceSettings& options, double at, double thickness) {
  const auto& slice = options.picture.slice;
  CellSliceOptions look{.window = slice.window,
                        .width = slice.width,
                        .height = slice.height,
                        .title = slice.title,
                        .unit = slice.unit};
  if (look.title.empty()) {
    const double part = 1e-3 * thickness;  // more digits say nothing
    look.title = fileName(options.surface) + ", " + "xyz"[options.picture.axis] + " = " +
                 number(part * std::round(at / part) + 0.0, 4) +
                 (slice.unit.empty() ? "" : " " + slice.unit);
  }
  return look;
}

void drawCells(const SliceSettings& options, const Solid<double>& solid) {
  const auto axis = options.picture.axis;
  const auto grid = shownCells(options, solid);
  requirePixels(options, grid.indices);
  const Cutter cutter(solid, options.cutting);
  Stopwatch watch;
  const auto cells = [&] {
    ProgressBar bar("cutting", !options.surface.quiet);
    return cutter.cut(
        grid, {.polygons = true, .threads = options.surface.threads, .progress = bar.callback()});
  }();
  const auto layer = cells.boxOf(cells.grid.first);
  const auto shown = lookOf(options, layer.center()[axis], layer.size()[axis]);
  const auto index = axis == 0   ? cells.grid.first.i
                     : axis == 1 ? cells.grid.first.j
                                 : cells.grid.first.k;
  writePng(options.picture.output, renderCells(cells, axis, index, shown));
  if (!options.surface.quiet) reportCells(options, cells, watch.lap());
}

/// The octree around the surface, if there is room for it.
Octree<double> octreeAround(const SliceSettings& options, const Solid<double>& solid) {
  auto wanted = options.octree;
  wanted.roots.box = options.grid.box;
  wanted.roots.margin = options.grid.margin;
  const auto domain = domainAround(boxAround(solid), wanted);
  const auto rules = rulesFor(wanted.refinement, solid.patchNames());
  OctreeOptions mesh{.balance = wanted.balance, .threads = options.surface.threads};
  constexpr double kBytes = OctreeEstimate::kBytesPerCell;
  requireRoom(wanted, estimate(solid, domain, rules, mesh), kBytes, 0, !options.surface.quiet);
  mesh.maxCells = static_cast<std::size_t>(mostCells(wanted, kBytes));
  ProgressBar bar("meshing", !options.surface.quiet);
  mesh.progress = bar.callback();
  return Octree<double>(solid, domain, rules, mesh);
}

/// The leaves that a plane meets, and that are in the window.
OctreeCells<double> shownLeaves(const SliceSettings& options, const Octree<double>& mesh,
                                double at) {
  const int axis = options.picture.axis;
  const int right = axis == 0 ? 1 : 0;
  const int up = axis == 2 ? 1 : 2;
  const auto& window = options.picture.slice.window;
  std::vector<OctreeCell> shown;
  for (const auto& cell : mesh.cells()) {
    const auto box = mesh.box(cell);
    if (!(box.lower[axis] <= at && at < box.upper[axis])) continue;
    const bool isIn =
        !window || (box.lower[right] < window->upper[0] && box.upper[right] > window->lower[0] &&
                    box.lower[up] < window->upper[1] && box.upper[up] > window->lower[1]);
    if (isIn) shown.push_back(cell);
  }
  if (shown.empty()) {
    throw Error(ErrorKind::Argument, "there are no cells in the window where " +
                                         std::string(1, "xyz"[axis]) + " = " + number(at) +
                                         ": --box or --margin makes the octree larger");
  }
  return {mesh.domain(), mesh.deepest(), std::move(shown)};
}

/// @throws Error(Limit) if most of the smallest leaves could not be seen.
void requirePixels(const SliceSettings& options, const OctreeCells<double>& leaves) {
  Box<double> shown;
  double smallest = leaves.domain().spacing();
  for (const auto& leaf : leaves.cells()) {
    const auto box = leaves.box(leaf);
    shown.extend(box.lower);
    shown.extend(box.upper);
    smallest = std::min(smallest, box.size().x);
  }
  const auto size = shown.size() / smallest;
  const auto count = [&](int axis) {
    return static_cast<std::int32_t>(std::min(std::round(size[axis]), 1e9));
  };
  requirePixels(options, IndexBox::ofSize(count(0), count(1), count(2)));
}

void drawLeaves(const SliceSettings& options, const Solid<double>& solid) {
  refuseOnOctrees(options.cutting);
  const int axis = options.picture.axis;
  const auto mesh = octreeAround(options, solid);
  // Between the planes of the finest leaves, as a grid of these is drawn.
  const auto finest = mesh.domain().level(mesh.deepest());
  const double wanted = options.picture.at.value_or(boxAround(solid).center()[axis]);
  const double origin = mesh.domain().origin()[axis];
  const double thickness = finest.spacing()[axis];
  const double at = origin + (std::floor((wanted - origin) / thickness) + 0.5) * thickness;
  const auto leaves = shownLeaves(options, mesh, at);
  requirePixels(options, leaves);
  const Cutter cutter(solid, options.cutting);
  Stopwatch watch;
  const auto cells = [&] {
    ProgressBar bar("cutting", !options.surface.quiet);
    return cutter.cut(
        leaves, {.polygons = true, .threads = options.surface.threads, .progress = bar.callback()});
  }();
  const auto look = lookOf(options, at, thickness);
  writePng(options.picture.output, renderCells(cells, leaves, axis, at, look));
  if (options.surface.quiet) return;
  Shown shown{.where = std::string("of an octree where ") + "xyz"[axis] + " = " + number(at),
              .cells = leaves.cells().size()};
  count(cells.cut, cells.cut.leaf.size(), shown);
  report(options, shown, watch.lap());
}

void run(const SliceSettings& options, bool onOctree) {
  if (!onOctree && !options.isOfCells() && options.saysWhichCells()) {
    throw Error(
        ErrorKind::Argument,
        "--inside, --open, --baffle, --cap-holes, --period, --tolerance, --box and --margin "
        "are for a picture of cells: with --cells, --spacing, --total or --level");
  }
  const auto solid = loadSolid(options.surface);
  if (onOctree) {
    drawLeaves(options, solid);
  } else if (options.isOfCells()) {
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
  const auto level = addOctreeOptions(command, options->octree);
  addLimits(command, "--max-cells", options->octree.limits);
  for (const char* of : {"--max-cells", "--max-memory"}) command.option(of).needs(level);
  command.setFooter(
      "Examples:\n"
      "  cutwater slice hull.stl -o hull.png\n"
      "  cutwater slice hull.stl --axis z --at 0.2 --unit m --title \"Waterline\" -o water.png\n"
      "  cutwater slice part.stl --scale 0.001 --window -0.1,0,0.1,0.05 --size 2400x1200 -o "
      "detail.png\n"
      "  cutwater slice hull.stl --spacing 0.02 --window 5.6,0,6.1,0.3 -o cells.png\n"
      "  cutwater slice hull.stl --level 4 --edges 30:6 -o leaves.png");
  command.setAction([=] {
    passOn(options->cutting, options->grid, options->surface);
    run(*options, command.isGiven("--level"));
  });
}

}  // namespace cutwater::tool
