#include "Report/InfoFacts.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "Options/RepairSteps.hpp"
#include "Report/Format.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/PeakMemory.hpp"
#include "Report/StepLine.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

constexpr std::size_t kLarge = 50'000;  // polygons: examining them takes about a second

/// The file as suggested commands name it: what was read from a pipe can't be read again.
std::string readableName(const SurfaceOptions& options) {
  const auto& file = options.file;
  std::error_code ignored;
  const bool isKept = std::filesystem::is_regular_file(file, ignored) &&
                      !file.starts_with("/dev/") && !file.starts_with("/proc/");
  return isKept ? file : "FILE";
}

/// Suggested file for a repaired surface: "hull-repaired.stl" for models/hull.stl.gz.
std::string repairedName(const LoadedSurface& surface, const std::string& file) {
  std::filesystem::path name = std::filesystem::path(file).filename();
  if (name.extension() == ".gz") name = name.stem();
  const auto format = surface.report.format;
  const bool isWritten = !surface.prepared && format != SurfaceFormat::Vtp;
  return name.stem().string() + "-repaired" +
         std::string(namesOf(isWritten ? format : SurfaceFormat::Ply).extension);
}

std::vector<Advice> adviceFor(const InfoFacts& facts) {
  const auto name = readableName(facts.options);
  const auto file = fileWord(name) + facts.options.motions;
  const auto output = fileWord(repairedName(facts.surface, name));
  std::vector<Advice> next;
  for (const auto& treatment : facts.found.treatments) {
    const std::string start = next.empty() ? "" : "or: ";
    next.push_back({"cutwater repair " + file + " -o " + output + commandLine(optionsOf(treatment)),
                    start + treatment.effect});
  }
  if (canMend() && facts.found.wrapGap) {
    RepairOptions options;
    options.mending.wrap = MendingOptions::Wrap{.gap = *facts.found.wrapGap};
    next.push_back({"cutwater repair " + file + " -o " + output + commandLine(options),
                    (next.empty() ? "" : "or: ") +
                        std::string("a watertight surface around it, whatever it is; what is "
                                    "narrower than the gap is closed, finer details are lost")});
  }
  if (facts.found.signs) std::ranges::move(usesOf(file), std::back_inserter(next));
  return next;
}

}  // namespace

InfoFacts gather(const InfoOptions& options) {
  auto surface = load(options);
  InfoFacts facts{.options = options,
                  .surface = std::move(surface),
                  .bytesOnDisk = {},
                  .found = {},
                  .bytesInFloat = {},
                  .peakResidentBytes = {},
                  .next = {}};
  const auto& soup = facts.surface.soup;
  std::error_code ignored;
  const auto onDisk = std::filesystem::file_size(options.file, ignored);
  if (!ignored) facts.bytesOnDisk = onDisk;
  StepLine line(!options.quiet && soup.polygonCount() >= kLarge);
  facts.found = namingMemory(
      options.file + ": out of memory while examining " + grouped(soup.polygonCount(), "polygon"),
      [&] {
        return diagnose(soup, {.fillHoles = holeFilling(),
                               .onStep = [&](const char* step) { line.show(step); }});
      });
  if (facts.found.signs && options.inFloat) {
    facts.bytesInFloat =
        MeshSDF<float>(soup, {.findSelfIntersections = false, .probes = 0}).memoryBytes();
  }
  facts.peakResidentBytes = peakResidentBytes();
  facts.next = adviceFor(facts);
  return facts;
}

std::string formatOf(const LoadedSurface& surface) {
  if (surface.prepared) {
    const bool isSingle = surface.prepared->info.bytesPerNumber == sizeof(float);
    return std::string("prepared, ") + (isSingle ? "single" : "double") + " precision";
  }
  const auto& report = surface.report;
  std::string text = report.binary ? "binary " : "ASCII ";
  text += namesOf(report.format).name;
  return text + (report.compressed ? ", gzip-compressed" : "");
}

std::vector<std::size_t> polygonsPerPatch(const PolygonSoup& soup) {
  std::vector<std::size_t> polygons(soup.patchNames.size());
  for (const auto id : soup.patches) {
    if (id < polygons.size()) ++polygons[id];  // files prepared by programs may lack names
  }
  return polygons;
}

std::string meaningOf(const Guarantee<double>& guarantee) {
  if (guarantee.outside == Quality::Exact) return "exact on both sides of the surface";
  if (guarantee.continuous) return "to the nearest face, be it part of the solid's surface or not";
  return "to the nearest face; the sign jumps on the sheets that close holes";
}

std::optional<std::string> planeOf(const Opening& opening) {
  if (!opening.plane) return {};
  return std::string(1, "xyz"[opening.plane->axis]) + " = " + number(opening.plane->at);
}

std::size_t bytesPerTriangle(std::size_t bytes, const MeshReport& report) {
  return (bytes + report.triangles - 1) / report.triangles;
}

}  // namespace cutwater::tool
