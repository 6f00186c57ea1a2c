#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <system_error>

#include "Commands/Commands.hpp"
#include "Commands/Picture.hpp"
#include "Options/Arguments.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/MeshOptions.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Format.hpp"
#include "Report/MeshFields.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct AmrSettings {
  SurfaceOptions surface;
  std::string output;
  MeshOptions mesh;
  bool features = false;
  std::optional<Vec3<double>> keep;
  PictureOptions picture;
};

struct Seconds {
  double surface = 0;
  double mesh = 0;
  double values = 0;
  double file = 0;
};

void report(const AmrSettings& options, const Octree<double>& mesh, std::uint64_t sum,
            const Seconds& seconds) {
  const auto count = mesh.cells().size();
  std::error_code ignored;  // as for a pipe
  const auto size = std::filesystem::file_size(options.output, ignored);
  std::cout << "wrote " << onOneLine(options.output) << ": " << grouped(count, "cell")
            << (ignored ? "" : ", " + bytes(size)) << '\n';
  report(CellCounts(mesh), mesh.domain());
  std::cout << "checksum: cells and values " << hexadecimal(sum) << '\n';
  const double each = static_cast<double>(count) / (seconds.mesh + seconds.values);
  std::cout << "surface " << duration(seconds.surface) << ", mesh " << duration(seconds.mesh)
            << ", values " << duration(seconds.values) << ", file " << duration(seconds.file)
            << "; mesh and values: " << grouped(static_cast<std::size_t>(each))
            << " cells per second\n";
}

/// Covers the cells that the point's region of fluid does not reach.
void keepRegion(const Vec3<double>& keep, const Octree<double>& mesh, MeshFields& fields,
                bool isShown) {
  const auto cell = mesh.find(keep);
  if (!cell) {
    const auto box = mesh.domain().box();
    refuse("--keep", point(keep),
           "a point within the mesh, " + point(box.lower) + " to " + point(box.upper));
  }
  const FluidRegions<double> fluid(mesh);
  if (fluid.regionOf(*cell) == kNone) refuse("--keep", point(keep), "a point in the fluid");
  const auto cells = fluid.unreached(mesh, keep);
  fields.cover(cells);
  if (!isShown) return;
  std::cout << "fluid: " << grouped(fluid.regions().size(), "region") << "; not reached from "
            << point(keep) << ", and covered: " << grouped(cells.size(), "cell") << '\n';
}

/// How fine cells must be to resolve the feature.
std::string remedy(const UnresolvedFeature<double>& feature, const Octree<double>& mesh) {
  const auto level = std::to_string(feature.level);
  const int halvings = feature.level - int{mesh.cells()[feature.cell].level};
  if (halvings <= 0) return "as wide as its cell of level " + level + " already";
  if (std::ldexp(feature.depth, halvings) < 0.99) return "no level resolves it";
  return "level " + level + " resolves it";
}

/// Reports the first few of each kind.
void reportFeatures(const SignedDistanceFunction<double>& solid, const Octree<double>& mesh,
                    int threads) {
  using Feature = UnresolvedFeature<double>;
  constexpr int kFew = 5;
  Stopwatch watch;
  const auto features = [&] {
    ProgressBar bar("looking for what is lost", true);
    return unresolvedFeatures(solid, mesh, {.threads = threads, .progress = bar.callback()});
  }();
  const double seconds = watch.lap();
  const std::pair<UnresolvedKind, const char*> kinds[] = {
      {UnresolvedKind::Thin, "thin: no corner of the cell sees it"},
      {UnresolvedKind::Grazing, "grazing: a bulge through a face"},
      {UnresolvedKind::MultiCut, "multi-cut: several sheets"}};
  std::cout << "unresolved features: " << grouped(features.size(), "cell") << ", in "
            << duration(seconds) << '\n';
  for (const auto& [kind, meaning] : kinds) {
    const auto first = std::ranges::lower_bound(features, kind, {}, &Feature::kind);
    const auto last = std::ranges::upper_bound(features, kind, {}, &Feature::kind);
    std::cout << "  " << meaning << ": " << grouped(static_cast<std::size_t>(last - first)) << '\n';
    for (auto feature = first; feature != last && feature - first < kFew; ++feature) {
      std::cout << "    " << (feature->isSolid ? "solid" : "fluid") << ' '
                << number(feature->depth, 3) << " cells deep at " << point(feature->point) << "; "
                << remedy(*feature, mesh) << '\n';
    }
    if (last - first > kFew) {
      std::cout << "    ... and " << grouped(static_cast<std::size_t>(last - first - kFew))
                << " more\n";
    }
  }
}

/// Of the value in a cell, from those of a coarse mesh.
double secondsPerValue(const Solid<double>& solid, const OctreeDomain<double>& domain,
                       const OctreeEstimate& estimated, int threads) {
  constexpr double kFew = 4000;
  const int level = std::min(estimated.finestWithin(kFew), estimated.deepest());
  if (level < 0) return 0;
  const Octree<double> mesh(solid, domain, {.cut = level}, {.threads = threads});
  std::vector<double> distance(mesh.cells().size());
  Stopwatch watch;
  fill(solid, mesh, {.distance = distance}, {.threads = threads});
  return watch.lap() / static_cast<double>(distance.size());
}

/// The options of a mesh that has room.
/// @throws Error(Limit) if it has none.
OctreeOptions withRoom(const Solid<double>& solid, const OctreeDomain<double>& domain,
                       const Refinement<double>& rules, const AmrSettings& options) {
  const int threads = options.surface.threads;
  OctreeOptions mesh{
      .balance = options.mesh.balance,
      .maxCells = static_cast<std::size_t>(mostCells(options.mesh, bytesPerCell(options.mesh))),
      .threads = threads};
  const auto estimated = estimate(solid, domain, rules, mesh);
  requireRoom(options.mesh, estimated, bytesPerCell(options.mesh),
              secondsPerValue(solid, domain, estimated, threads), !options.surface.quiet);
  return mesh;
}

void run(const AmrSettings& options) {
  const int threads = options.surface.threads;
  const bool isShown = !options.surface.quiet;
  Seconds seconds;
  Stopwatch watch;
  const auto solid = loadSolid(options.surface);
  const auto domain = domainAround(boxAround(solid), options.mesh);
  const auto rules = rulesFor(options.mesh.refinement, solid.patchNames());
  seconds.surface = watch.lap();
  auto meshOptions = withRoom(solid, domain, rules, options);
  const auto mesh = [&] {
    ProgressBar bar("meshing", isShown);
    meshOptions.progress = bar.callback();
    return Octree<double>(solid, domain, rules, meshOptions);
  }();
  seconds.mesh = watch.lap();
  MeshFields fields(mesh, options.mesh.write);
  {
    ProgressBar bar("evaluating", isShown);
    fill(solid, mesh, fields.targets(), {.threads = threads, .progress = bar.callback()});
  }
  if (fields.hasPatches()) fields.setPatches(cellPatches(solid, mesh, {.threads = threads}));
  seconds.values = watch.lap();
  const auto sum = checksum(mesh, fields.targets(), threads);
  if (options.keep) keepRegion(*options.keep, mesh, fields, isShown);
  writeVtu(options.output, mesh, fields.arrays(),
           {.threads = threads, .patchNames = fields.patchNamesOf(solid)});
  seconds.file = watch.lap();
  if (isShown) report(options, mesh, sum, seconds);
  if (isShown && options.features) reportFeatures(solid, mesh, threads);
  if (!options.picture.output.empty()) {
    auto picture = options.picture;
    picture.slice.mesh = &mesh;
    writePicture(solid, options.surface, picture);
  }
}

}  // namespace

void addAmr(Program& program) {
  const auto options = std::make_shared<AmrSettings>();
  auto command = program.addCommand(
      "amr", "Build an octree mesh around the surface, as a VTK grid that ParaView opens");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".vtu"}, "The mesh to write").required();
  addMeshOptions(command, options->mesh);
  command.add("--keep", "X,Y,Z",
              "A point in the fluid: cells that are not connected to it are covered, class 4",
              [=](const std::string& text) { options->keep = vectorOf("--keep", text); });
  command.addFlag("--features",
                  "List cells in which signs at corners do not tell all of the surface",
                  options->features);
  const auto picture = addOutput(command, "--picture", options->picture.output, {".png"},
                                 "Draw the mesh in a plane as well");
  addPictureOptions(command, options->picture);
  for (const char* of : {"--axis", "--at", "--window", "--size", "--title", "--unit"}) {
    command.option(of).needs(picture);
  }
  command.setFooter(
      "Examples:\n"
      "  cutwater amr hull.stl --level 6 -o hull.vtu\n"
      "  cutwater amr hull.stl --level 9 --band 0.1:7 --band 0.5:5 -o hull.vtu\n"
      "  cutwater amr ship.stl --level 6 --patch propeller:9 --edges 40:8 --gaps 4:9 -o ship.vtu\n"
      "  cutwater amr hull.stl --level 6 --features --picture hull.png --axis z -o hull.vtu\n"
      "  cutwater amr part.stl --scale 0.001 --box -1,-1,-1,3,1,1 --roots 8 --level 5 --balance "
      "face --write distance,normal,patch,class,level -o part.vtu");
  command.setAction([=] {
    try {
      run(*options);
    } catch (const std::bad_alloc&) {
      throw Error(ErrorKind::Limit,
                  "out of memory; use a lower --level: each has about four times the cells of the "
                  "one before");
    }
  });
}

}  // namespace cutwater::tool
