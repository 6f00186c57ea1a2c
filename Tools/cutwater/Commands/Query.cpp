#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Format.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct QuerySettings {
  SurfaceOptions surface;
  std::string points;
  std::string output;
  bool cells = false;
  std::string prefix;
  std::vector<std::string> write{"distance", "closest", "normal", "patch"};
};

/// The requested answers about points, as rows of arrays.
class PointAnswersTable {
 public:
  PointAnswersTable(std::size_t points, const std::vector<std::string>& names) {
    const auto isWanted = [&](const char* name) { return std::ranges::count(names, name) > 0; };
    if (isWanted("distance")) distance_.resize(points);
    if (isWanted("closest")) closest_.resize(3 * points);
    if (isWanted("normal")) normal_.resize(3 * points);
    if (isWanted("patch")) patch_.resize(points);
  }

  void fill(const Solid<double>& solid, std::span<const Vec3<double>> points, int threads,
            const Progress& progress) {
    if (closest_.empty() && normal_.empty() && patch_.empty()) {
      solid.signedDistances(points, distance_, {.threads = threads, .progress = progress});
      return;
    }
    // Closest points have much more than is kept of them: some at a time.
    constexpr std::size_t kStretch = std::size_t{1} << 16U;
    std::vector<SurfacePoint<double>> found(std::min(points.size(), kStretch));
    for (std::size_t first = 0; first < points.size(); first += kStretch) {
      const auto some = points.subspan(first, std::min(kStretch, points.size() - first));
      const auto results = std::span(found).first(some.size());
      solid.closestPoints(some, results, {.threads = threads});
      for (std::size_t i = 0; i < some.size(); ++i) keep(results[i], first + i);
      if (progress) {
        progress(static_cast<double>(first + some.size()) / static_cast<double>(points.size()));
      }
    }
  }

  [[nodiscard]] std::span<const double> distance() const { return distance_; }

  /// Moves the arrays to the others.
  void addTo(std::vector<DataArray>& arrays, const std::string& prefix) && {
    if (!distance_.empty()) arrays.push_back({prefix + "distance", std::move(distance_)});
    if (!closest_.empty()) arrays.push_back({prefix + "closest", std::move(closest_), 3});
    if (!normal_.empty()) arrays.push_back({prefix + "normal", std::move(normal_), 3});
    if (!patch_.empty()) arrays.push_back({prefix + "patch", std::move(patch_)});
  }

 private:
  void keep(const SurfacePoint<double>& nearest, std::size_t i) {
    if (!distance_.empty()) distance_[i] = nearest.distance;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = static_cast<int>(axis);
      if (!closest_.empty()) closest_[3 * i + axis] = nearest.point[component];
      if (!normal_.empty()) normal_[3 * i + axis] = nearest.normal[component];
    }
    if (patch_.empty()) return;
    static_assert(static_cast<std::int32_t>(kNone) == -1);
    patch_[i] = static_cast<std::int32_t>(nearest.owner.patch);
  }

  std::vector<double> distance_;
  std::vector<double> closest_;
  std::vector<double> normal_;
  std::vector<std::int32_t> patch_;
};

/// @throws Error if the file has an array of a name that is to be added.
void requireFreeNames(const QuerySettings& options, const std::vector<DataArray>& arrays) {
  for (const auto& name : options.write) {
    const auto isNamesake = [&](const DataArray& a) { return a.name == options.prefix + name; };
    if (std::ranges::none_of(arrays, isNamesake)) continue;
    throw Error(ErrorKind::Argument, options.points + ": there is an array named \"" +
                                         options.prefix + name +
                                         "\" already; give the new ones another name by --prefix");
  }
}

/// That the output has no place for the names of patches, if so.
std::string lossOfNames(const QuerySettings& options, const PointData& data) {
  const auto extension = extensionOf(options.output);
  const bool keepsNames = extension == ".vtu" || extension == ".vtp";
  if (keepsNames || data.patchNames.empty()) return {};
  return "note: this format does not keep the names of " +
         grouped(data.patchNames.size(), "patch") + "; .vtu and .vtp do\n";
}

void report(const QuerySettings& options, const PointData& data, const PointAnswersTable& answers,
            std::size_t count, double seconds) {
  const std::string what = options.cells ? "centres of cells" : "points";
  for (const auto& note : data.notes)
    std::cout << onOneLine(options.points) << ": " << note << '\n';
  std::cout << "asked at " << grouped(count) << ' ' << what << " in " << duration(seconds) << '\n';
  const auto distances = answers.distance();
  if (distances.empty()) return;
  const auto inside =
      std::count_if(distances.begin(), distances.end(), [](double d) { return d < 0; });
  const auto [least, most] = std::ranges::minmax(distances);
  std::cout << "inside: " << grouped(static_cast<std::size_t>(inside)) << "; distances from "
            << number(least, 6) << " to " << number(most, 6) << '\n';
}

void run(const QuerySettings& options) {
  auto data = namingMemory(options.points + ": out of memory while reading it",
                           [&] { return readPointData(options.points); });
  if (options.cells && data.cells.count() == 0) {
    throw Error(ErrorKind::Argument, options.points + ": --cells, but the file has no cells");
  }
  auto& arrays = options.cells ? data.cellArrays : data.pointArrays;
  requireFreeNames(options, arrays);
  requireWritable(options.output, data);
  const auto solid = loadSolid(options.surface);
  const auto centers = options.cells ? cellCenters(data) : std::vector<Vec3<double>>{};
  const auto& points = options.cells ? centers : data.points;
  PointAnswersTable answers(points.size(), options.write);
  Stopwatch watch;
  {
    ProgressBar bar("asking", !options.surface.quiet);
    answers.fill(solid, points, options.surface.threads, bar.callback());
  }
  const double seconds = watch.lap();
  if (!options.surface.quiet) report(options, data, answers, points.size(), seconds);
  std::move(answers).addTo(arrays, options.prefix);
  const auto names = solid.patchNames();
  // The name of an only patch is left out: some programs cannot read texts in these files.
  if (names.size() > 1 && std::ranges::count(options.write, "patch") > 0) data.patchNames = names;
  writePointData(options.output, data);
  if (options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << '\n' << lossOfNames(options, data);
}

}  // namespace

void addQuery(Program& program) {
  const auto options = std::make_shared<QuerySettings>();
  auto command = program.addCommand(
      "query", "Ask at the points or cells of a file: distance, closest point, normal, patch");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  command
      .addText(
          "POINTS",
          "The points: CSV with columns x, y and z, VTK's .vtu, .vtp or .vtk, or NumPy's .npy, "
          "also gzip-compressed",
          options->points)
      .required();
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".csv", ".vtu", ".vtp", ".vtk", ".npy"},
            "The file to write: the points with all that their file has, and the answers")
      .required();
  command.addFlag("--cells", "Ask at the mean of each cell's corners, not at the points",
                  options->cells);
  command.addWords("--write", "distance,closest,normal,patch",
                   "What to add; patch is that of the closest point, -1 if there is none [default: "
                   "all]",
                   options->write, {"distance", "closest", "normal", "patch"}, Values::Several);
  command.addText("--prefix", "Put this before the names of what is added", options->prefix);
  command.setFooter(
      "Examples:\n"
      "  cutwater query hull.stl points.csv -o answers.csv\n"
      "  cutwater query hull.stl mesh.vtu --cells --write distance -o walls.vtu\n"
      "  cutwater query flange.toml probes.npy -o answers.npy");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
