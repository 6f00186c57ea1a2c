#include <Cutwater/Core/Error.hpp>

#include <cmath>
#include <sstream>

#include "Report/InfoFacts.hpp"
#include "Report/JsonViews.hpp"
#include "Report/Page.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream rest(text);
  for (std::string line; std::getline(rest, line);) lines.push_back(line);
  return lines;
}

/// Coordinates that rounding has left near 0 are 0.
Box<double> withoutDust(Box<double> box) {
  if (box.empty() || !isFinite(box)) return box;
  const double dust = 1e-12 * maxComponent(box.size());
  for (auto* corner : {&box.lower, &box.upper}) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs((*corner)[axis]) < dust) (*corner)[axis] = 0;
    }
  }
  return box;
}

std::string pageOf(const InfoOptions& options, const Solid<double>& solid, double seconds) {
  Page page;
  page.section("File");
  page.line("name", options.file);
  page.line("format", "scene");
  page.section("Solid");
  page.lines(solid.describe());
  const auto box = withoutDust(solid.boundingBox());
  page.line("bounding box", box.empty() ? "none: there are no points in it"
                                        : point(box.lower) + " to " + point(box.upper));
  if (!box.empty()) page.line("extent", extent(box.size()));
  const auto patches = solid.patchNames();
  page.section("Patches: " + grouped(patches.size()));
  for (std::size_t i = 0; i < patches.size(); ++i) page.line(grouped(i), patches[i]);
  page.section("Timings");
  page.line("build", duration(seconds));
  return page.text();
}

std::string jsonOf(const InfoOptions& options, const Solid<double>& solid, double seconds) {
  return Json{{"file", {{"name", options.file}, {"format", "scene"}}},
              {"expression", linesOf(solid.describe())},
              {"boundingBox", toJson(solid.boundingBox())},
              {"patches", solid.patchNames()},
              {"seconds", {{"build", seconds}}}}
      .text();
}

}  // namespace

std::string aboutScene(const InfoOptions& options) {
  if (options.inFloat) {
    throw Error(ErrorKind::Argument, options.file + ": --float is for surfaces");
  }
  Stopwatch watch;
  const auto solid = loadSolid(options);
  const double seconds = watch.lap();
  return options.json ? jsonOf(options, solid, seconds) : pageOf(options, solid, seconds);
}

}  // namespace cutwater::tool
