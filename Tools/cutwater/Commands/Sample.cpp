#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
#include "Options/Limits.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Options/SampleGrid.hpp"
#include "Report/Format.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct SampleSettings {
  SurfaceOptions surface;
  std::string output;
  GridRequest grid;
  Limits limits;
  double band = 0;
  std::vector<std::string> write{"distance"};
};

/// The requested arrays, in the forms that fill() and a file take.
class Fields {
 public:
  Fields(const IndexBox& box, const std::vector<std::string>& names) {
    for (const auto& name : names) {
      if (name == "distance" && distance_.empty()) {
        distance_.resize(box.count());
        targets_.distance = GridView<double>::contiguous(distance_.data(), box);
        arrays_.push_back({name, std::span<const double>(distance_)});
      } else if (name == "patch" && patch_.empty()) {
        patch_.resize(box.count());
        targets_.patch = GridView<std::uint32_t>::contiguous(patch_.data(), box);
        // Where there is none, viewers get -1.
        static_assert(static_cast<std::int32_t>(kNone) == -1);
        const auto* const first = reinterpret_cast<const std::int32_t*>(patch_.data());
        arrays_.push_back({name, std::span(first, patch_.size())});
      } else if (name == "class" && classes_.empty()) {
        classes_.resize(box.count());
        targets_.boxClass = GridView<BoxClass>::contiguous(classes_.data(), box);
        const auto* const first = reinterpret_cast<const std::uint8_t*>(classes_.data());
        arrays_.push_back({name, std::span(first, classes_.size())});
      }
    }
  }

  [[nodiscard]] const FillTargets<double>& targets() const { return targets_; }
  [[nodiscard]] std::span<const VtkArray> arrays() const { return arrays_; }
  [[nodiscard]] bool hasPatch() const { return !patch_.empty(); }
  [[nodiscard]] std::span<const double> distance() const { return distance_; }

 private:
  std::vector<double> distance_;
  std::vector<std::uint32_t> patch_;
  std::vector<BoxClass> classes_;
  FillTargets<double> targets_;
  std::vector<VtkArray> arrays_;
};

void report(const SampleSettings& options, const GridPatch<double>& grid, const Fields& fields,
            double seconds) {
  const auto& n = grid.indices;
  const std::string kind = options.grid.nodes ? "nodes" : "cells";
  std::cout << "wrote " << onOneLine(options.output) << ": " << n.length(0) << " x " << n.length(1)
            << " x " << n.length(2) << " = " << grouped(n.count()) << ' ' << kind << " of "
            << extent(grid.level.spacing()) << '\n';
  const auto distances = fields.distance();
  if (!distances.empty()) {
    const auto inside =
        std::count_if(distances.begin(), distances.end(), [](double d) { return d < 0; });
    std::cout << "inside: " << grouped(static_cast<std::size_t>(inside)) << ' ' << kind << '\n';
  }
  const double each = seconds / static_cast<double>(n.count());
  std::cout << "sampled in " << duration(seconds) << ", " << number(each * 1e9, 3) << " ns each\n";
}

/// Of the arrays' values at an index.
double bytesOfValues(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) { return std::ranges::count(names, name) > 0; };
  return (has("distance") ? 8.0 : 0.0) + (has("patch") ? 4.0 : 0.0) + (has("class") ? 1.0 : 0.0);
}

/// Of filling the grid, from blocks all over it.
double secondsToFill(const Solid<double>& solid, const GridPatch<double>& grid,
                     const FillOptions& options) {
  double points = 0;
  Stopwatch watch;
  for (const auto& block : blocksOf(grid.indices)) {
    std::vector<double> values(block.count());
    const auto view = GridView<double>::contiguous(values.data(), block);
    fill(solid, {grid.level, block}, view, options);
    points += static_cast<double>(values.size());
  }
  return watch.lap() * static_cast<double>(grid.indices.count()) / points;
}

/// @throws Error(Limit) if the grid has no room within the limits.
void requireRoom(const Solid<double>& solid, const GridPatch<double>& grid,
                 const SampleSettings& options, const FillOptions& how) {
  const auto count = static_cast<double>(grid.indices.count());
  const double each = bytesOfValues(options.write);
  Expected expected{.what = "cells", .items = count, .bytes = count * each, .isExact = true};
  const double most = options.limits.mostBytes() / each;
  const auto remedy = [&] {
    const double fitting = std::min(most, options.limits.items.value_or(most));
    return sizeThatFits(grid, std::cbrt(count / fitting));
  };
  requireWithin(options.limits, expected, false, remedy);
  constexpr double kFew = 1e6;  // values, for which it is not worth while
  if (count > kFew) expected.seconds = secondsToFill(solid, grid, how);
  requireWithin(options.limits, expected, !options.surface.quiet, remedy);
}

void sample(const Solid<double>& solid, const GridPatch<double>& grid,
            const SampleSettings& options, FillOptions how) {
  const Fields fields(grid.indices, options.write);
  Stopwatch watch;
  {
    ProgressBar bar("sampling", !options.surface.quiet);
    how.progress = bar.callback();
    fill(solid, grid, fields.targets(), how);
  }
  const double seconds = watch.lap();
  writeVti(options.output, grid, fields.arrays(),
           {.patchNames = fields.hasPatch() ? solid.patchNames() : std::vector<std::string>{}});
  if (!options.surface.quiet) report(options, grid, fields, seconds);
}

void run(const SampleSettings& options) {
  const auto solid = loadSolid(options.surface);
  const auto grid = gridAround(boxAround(solid), options.grid);
  const FillOptions how{.band = options.band, .threads = options.surface.threads};
  requireRoom(solid, grid, options, how);
  namingMemory("out of memory with " + grouped(grid.indices.count()) + " values; use fewer --cells",
               [&] { sample(solid, grid, options, how); });
}

}  // namespace

void addSample(Program& program) {
  const auto options = std::make_shared<SampleSettings>();
  auto command = program.addCommand(
      "sample", "Sample the signed distance on a grid, as a VTK image that ParaView opens");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".vti"}, "The image to write").required();
  addSizeOptions(command, options->grid);
  addPlaceOptions(command, options->grid);
  addLimits(command, "--max-cells", options->limits);
  command.addFlag("--nodes", "Values at the nodes of the cells, not at their centres",
                  options->grid.nodes);
  command.add("--band", "CELLS",
              "Tell distances within so many cells of the surface, by the smallest of their sides; "
              "beyond, just this width and the sign",
              [=](const std::string& text) { options->band = positiveNumber("--band", text); });
  command.addWords("--write", "distance,patch,class",
                   "What to write; patch is that of the closest surface point, -1 beyond the band; "
                   "class is that of the cell: 0 inside, 1 outside, 2 cut, 3 unknown "
                   "[default: distance]",
                   options->write, {"distance", "patch", "class"}, Values::Several);
  command.setFooter(
      "Examples:\n"
      "  cutwater sample hull.stl -o hull.vti\n"
      "  cutwater sample hull.stl --spacing 0.02 --band 4 -o band.vti\n"
      "  cutwater sample part.stl --scale 0.001 --rotate 90,x --translate 0,0,1 --cells 200 -o "
      "part.vti\n"
      "  cutwater sample hull.stl --box -1,-1,-1,7,1,1 --cells 400x100x100 --write "
      "distance,patch -o hull.vti");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
