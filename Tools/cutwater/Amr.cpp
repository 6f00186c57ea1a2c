#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Io/Vtu.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <system_error>

#include "Arguments.hpp"
#include "Commands.hpp"
#include "Format.hpp"
#include "Picture.hpp"
#include "ProgressBar.hpp"
#include "SampleGrid.hpp"
#include "Surface.hpp"

namespace cutwater::tool {

namespace {

const std::map<std::string, Balance> kBalances{{"none", Balance::None},
                                               {"face", Balance::Face},
                                               {"edge", Balance::Edge},
                                               {"corner", Balance::Corner}};

constexpr std::uint8_t kCovered = 4;  // after those of BoxClass

struct Options {
  SurfaceOptions surface;
  std::string output;
  GridRequest roots;
  Refinement<double> refinement;
  Balance balance = Balance::Corner;
  std::vector<std::string> write{"distance", "class", "level"};
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

/// The arrays that were asked for, one value per cell.
class Fields {
 public:
  Fields(const Octree<double>& mesh, const std::vector<std::string>& names) {
    const auto count = mesh.cells().size();
    for (const auto& name : names) {
      if (name == "distance") add(name, distance_, count);
      if (name == "normal") add(name, normal_, count);
      if (name == "patch") add(name, patch_, count);
      if (name == "class") add(name, class_, count);
      if (name == "level") add(name, level_, count);
    }
    const auto cells = mesh.cells();
    for (std::size_t n = 0; n < class_.size(); ++n) {
      class_[n] = static_cast<std::uint8_t>(cells[n].kind);
    }
    for (std::size_t n = 0; n < level_.size(); ++n) level_[n] = cells[n].level;
  }

  /// Cells that are to be covered have a class of their own.
  void cover(std::span<const std::size_t> cells) {
    if (class_.empty()) return;
    for (const auto n : cells) class_[n] = kCovered;
  }
  [[nodiscard]] OctreeTargets<double> targets() { return {distance_, normal_, patch_}; }
  [[nodiscard]] std::span<const VtkArray> arrays() const { return arrays_; }

 private:
  template <typename Value>
  void add(const std::string& name, std::vector<Value>& values, std::size_t count) {
    if (!values.empty()) return;  // named twice
    values.resize(count);
    arrays_.push_back({name, std::span<const Value>(values)});
  }

  std::vector<double> distance_;
  std::vector<Vec3<double>> normal_;
  std::vector<std::uint32_t> patch_;
  std::vector<std::uint8_t> class_;
  std::vector<std::uint8_t> level_;
  std::vector<VtkArray> arrays_;
};

OctreeDomain<double> domainAround(const Box<double>& surface, const GridRequest& request) {
  const auto roots = gridAround(surface, request);
  const auto& n = roots.indices.hi;
  return {roots.level.origin(), roots.level.spacing().x, {n.i + 1, n.j + 1, n.k + 1}};
}

void reportCells(const Octree<double>& mesh) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(mesh.deepest()) + 1);
  for (const auto& cell : mesh.cells()) ++counts[cell.level];
  for (std::size_t level = 0; level < counts.size(); ++level) {
    const double width = mesh.domain().level(static_cast<int>(level)).spacing().x;
    std::cout << "level " << rightAligned(grouped(level), 2) << ": "
              << rightAligned(grouped(counts[level]), 13) << " cells of " << number(width) << '\n';
  }
  std::cout << "inside: " << grouped(mesh.count(BoxClass::Inside))
            << ", outside: " << grouped(mesh.count(BoxClass::Outside))
            << ", cut: " << grouped(mesh.count(BoxClass::Cut))
            << ", unknown: " << grouped(mesh.count(BoxClass::Unknown)) << " cells\n";
}

void report(const Options& options, const Octree<double>& mesh, const Seconds& seconds) {
  const auto count = mesh.cells().size();
  const auto& n = mesh.domain().roots();
  std::error_code ignored;  // of a pipe
  const auto size = std::filesystem::file_size(options.output, ignored);
  std::cout << "wrote " << options.output << ": " << counted(count, "cell")
            << (ignored ? "" : ", " + bytes(size)) << '\n';
  std::cout << "roots: " << n.i << " x " << n.j << " x " << n.k << ", from "
            << point(mesh.domain().box().lower) << " to " << point(mesh.domain().box().upper)
            << '\n';
  reportCells(mesh);
  const double each = static_cast<double>(count) / (seconds.mesh + seconds.values);
  std::cout << "surface " << duration(seconds.surface) << ", mesh " << duration(seconds.mesh)
            << ", values " << duration(seconds.values) << ", file " << duration(seconds.file)
            << "; mesh and values: " << grouped(static_cast<std::size_t>(each))
            << " cells per second\n";
}

/// Covers what the point's region of fluid does not reach.
void keepRegion(const Vec3<double>& keep, const Octree<double>& mesh, Fields& fields,
                bool isShown) {
  const FluidRegions<double> fluid(mesh);
  const auto cells = fluid.unreached(mesh, keep);
  fields.cover(cells);
  if (!isShown) return;
  std::cout << "fluid: " << counted(fluid.regions().size(), "region") << "; not reached from "
            << point(keep) << ", and covered: " << counted(cells.size(), "cell") << '\n';
}

/// Of each kind the first few.
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
  std::cout << "unresolved features: " << counted(features.size(), "cell") << ", in "
            << duration(seconds) << '\n';
  for (const auto& [kind, meaning] : kinds) {
    const auto first = std::ranges::lower_bound(features, kind, {}, &Feature::kind);
    const auto last = std::ranges::upper_bound(features, kind, {}, &Feature::kind);
    std::cout << "  " << meaning << ": " << grouped(static_cast<std::size_t>(last - first)) << '\n';
    for (auto feature = first; feature != last && feature - first < kFew; ++feature) {
      std::cout << "    " << (feature->isSolid ? "solid" : "fluid") << ' '
                << number(feature->depth, 3) << " cells deep at " << point(feature->point)
                << "; level " << feature->level << " resolves it\n";
    }
  }
}

void run(const Options& options) {
  const int threads = options.surface.threads;
  const bool isShown = !options.surface.quiet;
  Seconds seconds;
  Stopwatch watch;
  const auto solid = loadSolid(options.surface);
  const auto domain = domainAround(solid.boundingBox(), options.roots);
  seconds.surface = watch.lap();
  const auto mesh = [&] {
    ProgressBar bar("meshing", isShown);
    return Octree<double>(
        solid, domain, options.refinement,
        {.balance = options.balance, .threads = threads, .progress = bar.callback()});
  }();
  seconds.mesh = watch.lap();
  Fields fields(mesh, options.write);
  {
    ProgressBar bar("evaluating", isShown);
    fill(solid, mesh, fields.targets(), {.threads = threads, .progress = bar.callback()});
  }
  seconds.values = watch.lap();
  if (options.keep) keepRegion(*options.keep, mesh, fields, isShown);
  writeVtu(options.output, mesh, fields.arrays(), {.threads = threads});
  seconds.file = watch.lap();
  if (isShown) report(options, mesh, seconds);
  if (isShown && options.features) reportFeatures(solid, mesh, threads);
  if (!options.picture.output.empty()) {
    auto picture = options.picture;
    picture.slice.mesh = &mesh;
    writePicture(solid, options.surface, picture);
  }
}

/// "DISTANCE:LEVEL"
Refinement<double>::Band bandOf(const std::string& text) {
  const auto colon = text.find(':');
  const auto level = text.substr(colon == std::string::npos ? text.size() : colon + 1);
  if (level.empty() || level.find_first_not_of("0123456789") != std::string::npos ||
      level.size() > 2) {
    refuse("--band", text, "a distance and a level: 0.5:4");
  }
  const double distance = numbers("--band", text.substr(0, colon), 1).front();
  if (distance < 0) refuse("--band", text, "a distance from 0");
  return {distance, std::stoi(level)};
}

void addRefinement(CLI::App& command, Options& options) {
  command
      .add_option("--level", options.refinement.cut,
                  "Refine what the surface meets to this level: so many halvings of the roots")
      ->required()
      ->check(CLI::Range(0, 20))
      ->type_name("N");
  command
      .add_option_function<std::vector<std::string>>(
          "--band",
          [&](const std::vector<std::string>& texts) {
            for (const auto& text : texts) options.refinement.bands.push_back(bandOf(text));
          },
          "Refine what is within this distance of the surface, in its units, to that level; may be "
          "repeated")
      ->allow_extra_args(false)
      ->type_name("DISTANCE:LEVEL");
  command
      .add_option_function<std::string>(
          "--roots",
          [&](const std::string& text) {
            options.roots.cells = sizes("--roots", text);
            if (options.roots.cells.size() != 1) refuse("--roots", text, "one number");
          },
          "Cubes of level 0, N along the longest side; without it: 16")
      ->type_name("N");
  addPlaceOptions(command, options.roots);
  command
      .add_option("--balance", options.balance,
                  "Neighbours that differ by one level at most: across what; without it: corner")
      ->transform(CLI::CheckedTransformer(kBalances))
      ->type_name("none|face|edge|corner")
      ->option_text("none|face|edge|corner");
}

}  // namespace

void addAmr(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  options->roots.cells = {16};
  auto& command = *program.add_subcommand(
      "amr", "Build an octree mesh around the surface, as a VTK grid that ParaView opens");
  addSurfaceOptions(command, options->surface);
  addSignOptions(command, options->surface);
  command.add_option("-o,--output", options->output, "The mesh to write")
      ->required()
      ->type_name("FILE.vtu");
  addRefinement(command, *options);
  command
      .add_option("--write", options->write,
                  "Values of each cell, at its centre: class is 0 inside, 1 outside, 2 cut, 3 "
                  "unknown; normal and patch are those of the closest surface point; without it: "
                  "distance,class,level")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"distance", "normal", "patch", "class", "level"}))
      ->type_name("distance,normal,patch,class,level");
  command
      .add_option_function<std::string>(
          "--keep", [=](const std::string& text) { options->keep = vectorOf("--keep", text); },
          "A point in the fluid: cells that are not connected to it are covered, class 4")
      ->type_name("X,Y,Z");
  command.add_flag("--features", options->features,
                   "List cells in which signs at corners do not tell all of the surface");
  command.add_option("--picture", options->picture.output, "Draw the mesh in a plane as well")
      ->type_name("FILE.png");
  addPictureOptions(command, options->picture);
  command.footer(
      "Examples:\n"
      "  cutwater amr hull.stl --level 6 -o hull.vtu\n"
      "  cutwater amr hull.stl --level 9 --band 0.1:7 --band 0.5:5 -o hull.vtu\n"
      "  cutwater amr hull.stl --level 6 --features --picture hull.png --axis z -o hull.vtu\n"
      "  cutwater amr part.stl --scale 0.001 --box -1,-1,-1,3,1,1 --roots 8 --level 5 --balance "
      "face --write distance,normal,patch,class,level -o part.vtu");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
