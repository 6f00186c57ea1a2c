#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/SelfIntersections.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "Commands.hpp"
#include "Format.hpp"
#include "HeapUse.hpp"
#include "Surface.hpp"

namespace cutwater::tool {

namespace {

constexpr std::size_t kMostPatches = 40;  // listed

struct InfoOptions : SurfaceOptions {
  bool inFloat = false;
};

/// The lines of the report, section by section.
class Page {
 public:
  void section(const std::string& title) { text_ += "\n" + title + "\n"; }
  void line(const std::string& name, const std::string& value) {
    text_ += "  " + leftAligned(name, 18) + "  " + value + "\n";
  }
  void plain(const std::string& text) { text_ += "  " + text + "\n"; }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string formatOf(const LoadedSurface& surface) {
  if (surface.prepared) {
    const bool isSingle = surface.prepared->info.bytesPerNumber == sizeof(float);
    return std::string("prepared, ") + (isSingle ? "single" : "double") + " precision";
  }
  const auto& report = surface.report;
  constexpr const char* kNames[] = {"STL", "OBJ", "PLY", "OFF", "VTK"};
  std::string text = report.binary ? "binary " : "ASCII ";
  text += kNames[static_cast<std::size_t>(report.format)];
  return text + (report.compressed ? ", gzip-compressed" : "");
}

void describeFile(Page& page, const SurfaceOptions& options, const LoadedSurface& surface) {
  const auto& report = surface.report;
  page.section("File");
  page.line("name", options.file);
  page.line("format", formatOf(surface));
  std::error_code ignored;
  const auto onDisk = std::filesystem::file_size(options.file, ignored);
  page.line("size",
            bytes(report.bytes) +
                (report.compressed && !ignored ? ", " + bytes(onDisk) + " compressed" : ""));
  if (options.scale != 1) page.line("scaled by", number(options.scale));
  if (!options.placement.isIdentity()) page.line("moved", "as told by the options");
  for (const auto& note : report.notes) page.line("note", note);
  if (!surface.prepared) return;
  page.line("signs", surface.prepared->signs);
  if (const auto hash = surface.prepared->info.source; hash != 0) {
    page.line("made from", "a file of XXH64 " + hexadecimal(hash));
  }
}

void describeSurface(Page& page, const LoadedSurface& surface, const MeshReport& report) {
  const auto& soup = surface.soup;
  page.section("Surface");
  page.line("polygons",
            grouped(soup.polygonCount()) + (report.triangles == soup.polygonCount()
                                                ? ", all triangles"
                                                : ", as " + counted(report.triangles, "triangle")));
  page.line("points", grouped(soup.points.size()) + " (" + grouped(surface.report.pointsInFile) +
                          " in the file, " + grouped(surface.pointsMerged) +
                          " merged with equal ones)");
  const auto box = soup.boundingBox();
  if (!box.empty()) {
    page.line("bounding box", point(box.lower) + " to " + point(box.upper));
    page.line("extent", extent(box.size()));
  }
  page.line("area", number(report.area));
  page.line("volume", report.isClosed() ? number(report.volume) : "none: not closed");
  page.line("components", grouped(report.components));
}

void describePatches(Page& page, const PolygonSoup& soup) {
  std::vector<std::size_t> polygons(soup.patchNames.size());
  for (const auto id : soup.patches) {
    if (id < polygons.size()) ++polygons[id];  // prepared by programs, patches may have no name
  }
  page.section("Patches: " + grouped(polygons.size()));
  for (std::size_t i = 0; i < std::min(polygons.size(), kMostPatches); ++i) {
    page.line(rightAligned(grouped(i), 4) + "  " + soup.patchNames[i],
              counted(polygons[i], "polygon"));
  }
  if (polygons.size() > kMostPatches) {
    page.plain("... and " + grouped(polygons.size() - kMostPatches) + " more");
  }
}

/// "none", or how many and the first few.
std::string describe(const SelfIntersections& found) {
  if (!found) return "none";
  constexpr std::size_t kMostExamples = 3;
  const auto& examples = found.pairs.examples;
  std::string text = (found.complete ? "" : "at least ") + grouped(found.pairs.count) +
                     (found.pairs.count == 1 ? " pair of faces: " : " pairs of faces: ");
  for (std::size_t i = 0; i < std::min(examples.size(), kMostExamples); ++i) {
    const auto [first, second] = examples[i];
    text += (i == 0 ? "" : ", ") + std::to_string(index(first)) +
            (first == second ? " with itself" : " and " + std::to_string(index(second)));
  }
  return text + (found.pairs.count > kMostExamples ? ", ..." : "");
}

void describeCheck(Page& page, const MeshReport& report, const SelfIntersections& found) {
  page.section("Check");
  page.line("watertight", report.isClosedOriented() ? "yes" : "no");
  page.line("in short", report.summary());
  page.line("self-intersections", describe(found));
  if (report.isInsideOut()) {
    page.line("orientation", "inside out: normals point into the solid");
  }
  if (report.isClean()) return;
  page.section("Details: faces are polygons, vertices are points, both counted from 0");
  const auto table = report.table();
  for (std::string_view rest = table; !rest.empty();) {
    const auto line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size() + 1);
    if (!line.ends_with(" 0")) page.plain(std::string(line));  // defects that there are not
  }
}

std::string meaningOf(const Guarantee<double>& guarantee) {
  if (guarantee.outside == Quality::Exact) return "exact on both sides of the surface";
  if (guarantee.continuous) return "to the nearest face, be it part of the solid's surface or not";
  return "to the nearest face; the sign jumps on the sheets that close holes";
}

/// A solid with what building it took.
template <std::floating_point T>
struct Built {
  MeshSDF<T> solid;
  std::size_t peak;  ///< bytes, besides the soup
  double seconds;
};

template <std::floating_point T>
Built<T> built(const PolygonSoup& soup, const MeshSDFOptions& options) {
  Stopwatch watch;
  const HeapUse heap;
  MeshSDF<T> solid(soup, options);
  return {.solid = std::move(solid), .peak = heap.peak(), .seconds = watch.lap()};
}

template <std::floating_point T>
std::string memoryOf(const Built<T>& build) {
  const std::size_t size = build.solid.memoryBytes();
  const std::size_t triangles = build.solid.triangleCount();
  return bytes(size) + ", " + counted((size + triangles - 1) / triangles, "byte") +
         " per triangle; at most " + bytes(build.peak) + " while it was built, " +
         number(static_cast<double>(build.peak) / static_cast<double>(size), 3) + " times that";
}

/// What the surface is good for, and what to do next. Returns the time that building it took.
double describeUse(Page& page, const InfoOptions& options, const PolygonSoup& soup,
                   const MeshSDFOptions& how) {
  page.section("Signed distance");
  const auto build = built<double>(soup, how);
  page.line("signs", build.solid.signReport().summary());
  page.line("distances", meaningOf(build.solid.guarantee()));
  page.line("memory", memoryOf(build));
  if (options.inFloat) page.line("memory in float", memoryOf(built<float>(soup, how)));
  page.section("Next");
  page.plain("cutwater sample '" + options.file + "' -o field.vti");
  page.plain("cutwater slice '" + options.file + "' -o slice.png");
  return build.seconds;
}

void run(const InfoOptions& options) {
  const auto surface = load(options);
  Stopwatch watch;
  const DcelMesh<double> mesh(surface.soup);
  const auto report = check(mesh);
  const double secondsToCheck = watch.lap();
  const auto selfIntersections = findSelfIntersections(mesh);
  const double secondsToSearch = watch.lap();
  Page page;
  describeFile(page, options, surface);
  describeSurface(page, surface, report);
  describePatches(page, surface.soup);
  describeCheck(page, report, selfIntersections);
  std::optional<double> secondsToBuild;
  if (report.triangles > 0) {
    secondsToBuild = describeUse(page, options, surface.soup,
                                 {.findSelfIntersections = static_cast<bool>(selfIntersections)});
  }
  page.section("Timings");
  page.line("read", duration(surface.secondsToRead));
  page.line("weld", duration(surface.secondsToWeld));
  page.line("mesh and check", duration(secondsToCheck));
  page.line("self-intersections", duration(secondsToSearch));
  if (secondsToBuild) page.line("build", duration(*secondsToBuild));
  std::cout << page.text().substr(1);
}

}  // namespace

void addInfo(CLI::App& program) {
  const auto options = std::make_shared<InfoOptions>();
  auto& command = *program.add_subcommand(
      "info", "Read and check a surface, and say what it is: size, patches, defects, memory");
  addSurfaceOptions(command, *options);
  command.add_flag("--float", options->inFloat, "Say also what it takes in single precision");
  command.footer(
      "Examples:\n"
      "  cutwater info hull.stl.gz --float\n"
      "  cutwater info part.stl --scale 0.001 --rotate 90,x");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
