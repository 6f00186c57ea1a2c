#include "InfoFacts.hpp"

#include <Cutwater/Surface/Cleaning/Orientation.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "Format.hpp"
#include "HeapUse.hpp"

namespace cutwater::tool {

namespace {

/// Builds the solid, and passes it to `take`.
template <std::floating_point T, typename Take>
MemoryUse build(const PolygonSoup& soup, const MeshSDFOptions& options, Take take) {
  const HeapUse heap;
  const MeshSDF<T> solid(soup, options);
  take(solid);
  const std::size_t triangles = solid.triangleCount();
  return {.bytes = solid.memoryBytes(),
          .bytesPerTriangle = (solid.memoryBytes() + triangles - 1) / triangles,
          .peak = heap.peak()};
}

SolidFacts solidOf(const PolygonSoup& soup, const MeshSDFOptions& how, bool inFloat) {
  SolidFacts facts;
  Stopwatch watch;
  facts.memory = build<double>(soup, how, [&](const MeshSDF<double>& solid) {
    facts.seconds = watch.lap();
    facts.signs = solid.signReport();
    facts.guarantee = solid.guarantee();
  });
  if (inFloat) facts.memoryInFloat = build<float>(soup, how, [](const MeshSDF<float>&) {});
  return facts;
}

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
  constexpr const char* kExtensions[] = {".stl", ".obj", ".ply", ".off", ".ply"};
  std::filesystem::path name = std::filesystem::path(file).filename();
  if (name.extension() == ".gz") name = name.stem();
  const auto stem = name.stem().string();
  const auto format = static_cast<std::size_t>(surface.report.format);
  return stem + "-repaired" + (surface.prepared ? ".ply" : kExtensions[format]);
}

/// The volume of the solid that the signs describe: that of the shells, turned outward. Nothing
/// where they may overlap, or are open.
std::optional<double> solidVolumeOf(const PolygonSoup& soup, const MeshReport& report,
                                    const SignReport& signs) {
  if (signs.scheme != SignScheme::NearestFeature || !signs.isSound()) return {};
  if (signs.turnedFaces == 0 && signs.turnedShells == 0) return report.volume;
  auto outward = soup;
  orientFaces(outward);
  return measure(outward).volume;
}

/// Whether signs are ambiguous and no other repair would change that. Surfaces in one plane, such
/// as an inlet, are left alone.
bool needsWrap(const InfoFacts& facts) {
  const auto isError = [](const Defect& defect) { return defect.severity == Severity::Error; };
  return facts.solid && !flatAxis(facts.surface.soup) &&
         std::ranges::any_of(facts.defects, isError) &&
         std::ranges::none_of(facts.treatments.found, &Treatment::isClosed);
}

std::vector<Advice> adviceFor(const InfoFacts& facts) {
  const auto name = readableName(facts.options);
  const auto file = fileWord(name) + facts.options.motions;
  const auto output = fileWord(repairedName(facts.surface, name));
  std::vector<Advice> next;
  for (const auto& treatment : facts.treatments.found) {
    const std::string start = next.empty() ? "" : "or: ";
    next.push_back({"cutwater repair " + file + " -o " + output + commandLine(treatment.options),
                    start + treatment.effect});
  }
  if (canMend() && needsWrap(facts)) {
    const double gap = facts.surface.soup.boundingBox().diagonal() / 30;
    RepairOptions options;
    options.mending.wrap = MendingOptions::Wrap{.gap = rounded(gap, 1)};
    next.push_back({"cutwater repair " + file + " -o " + output + commandLine(options),
                    (next.empty() ? "" : "or: ") +
                        std::string("a watertight surface around it, whatever it is; what is "
                                    "narrower than the gap is closed, finer details are lost")});
  }
  if (facts.solid) std::ranges::move(usesOf(file), std::back_inserter(next));
  return next;
}

}  // namespace

InfoFacts gather(const InfoOptions& options) {
  auto surface = load(options);
  auto found = examine(surface.soup);
  InfoFacts facts{.options = options,
                  .surface = std::move(surface),
                  .bytesOnDisk = {},
                  .found = std::move(found),
                  .solid = {},
                  .solidVolume = {},
                  .defects = {},
                  .treatments = {},
                  .next = {}};
  const auto& soup = facts.surface.soup;
  std::error_code ignored;
  const auto onDisk = std::filesystem::file_size(options.file, ignored);
  if (!ignored) facts.bytesOnDisk = onDisk;
  if (facts.found.report.triangles > 0) {
    facts.solid =
        solidOf(soup, {.findSelfIntersections = static_cast<bool>(facts.found.selfIntersections)},
                options.inFloat);
    facts.solidVolume = solidVolumeOf(soup, facts.found.report, facts.solid->signs);
  }
  facts.defects = findDefects(soup, facts.found, facts.signs());
  Stopwatch watch;
  if (!facts.defects.empty()) facts.treatments = findTreatments(soup);
  facts.secondsToTreat = watch.lap();
  facts.next = adviceFor(facts);
  return facts;
}

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

std::optional<std::string> planeOf(const Rim& rim, const Treatments& treatments) {
  const auto plane = cutwater::planeOf(rim, treatments.planeTolerance);
  if (!plane) return {};
  return std::string(1, "xyz"[plane->axis]) + " = " + number(plane->at);
}

}  // namespace cutwater::tool
