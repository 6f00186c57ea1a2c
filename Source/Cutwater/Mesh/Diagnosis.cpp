#include <Cutwater/Mesh/Detail/DefectSearch.hpp>
#include <Cutwater/Mesh/Detail/TreatmentSearch.hpp>
#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Text/Numbers.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace cutwater {

namespace {

class Stopwatch {
 public:
  /// Seconds since the start or the last call.
  double lap() {
    const auto before = std::exchange(start_, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

bool hasAny(const std::vector<Defect>& defects, Severity severity) {
  return std::ranges::find(defects, severity, &Defect::severity) != defects.end();
}

std::optional<double> solidVolumeOf(const PolygonSoup& soup, const Diagnosis& found) {
  const SignReport& signs = *found.signs;
  if (signs.scheme != SignScheme::NearestFeature || !signs.isSound()) return {};
  if (signs.turnedFaces == 0 && signs.turnedShells == 0) return found.report.volume;
  auto outward = soup;
  orientFaces(outward);
  return measure(outward).volume;
}

/// Surfaces in one plane, such as an inlet, are left alone.
std::optional<double> wrapGapOf(const PolygonSoup& soup, const Diagnosis& found) {
  const bool isNeeded = found.signs && !detail::flatAxis(soup) &&
                        hasAny(found.defects, Severity::Error) &&
                        std::ranges::none_of(found.treatments, &Treatment::isClosed);
  if (!isNeeded) return {};
  return text::rounded(soup.boundingBox().diagonal() / 30, /*digits=*/1);
}

void decideSigns(const PolygonSoup& soup, Diagnosis& found) {
  Stopwatch watch;
  const MeshSDF<double> solid(soup);
  found.seconds.build = watch.lap();
  found.signs = solid.signReport();
  found.guarantee = solid.guarantee();
  found.memoryBytes = solid.memoryBytes();
}

}  // namespace

const char* nameOf(Severity severity) {
  constexpr const char* kNames[] = {"error", "warning", "note"};
  return kNames[static_cast<std::size_t>(severity)];
}

bool Diagnosis::isSound() const {
  return signs && signs->isSound() && !hasAny(defects, Severity::Error);
}

std::string Diagnosis::verdict() const {
  if (isSound()) {
    return std::string("bounds a solid: signs are exact, distances are those to the solid") +
           (hasAny(defects, Severity::Warning) ? "; see the warnings" : "");
  }
  if (hasAny(defects, Severity::Error)) {
    return "does not bound a solid without question: repair it, or look at a slice of its signs "
           "first";
  }
  return report.isClosed() ? "can be used as it is: signs hold, with the warnings below"
                           : "is not closed: signs are found nevertheless, see the warnings below";
}

Diagnosis diagnose(const PolygonSoup& soup, const DiagnosisOptions& options) {
  Diagnosis found;
  Stopwatch watch;
  const auto begin = [&](const char* step) {
    if (options.onStep) options.onStep(step);
  };
  begin("checking");
  {
    const DcelMesh<double> mesh(soup);
    found.report = check(mesh);
    found.seconds.check = watch.lap();
    begin("looking for self-intersections");
    found.selfIntersections = findSelfIntersections(mesh);
    found.seconds.selfIntersections = watch.lap();
    if (found.report.triangles > 0) {
      begin("building the tree and checking signs");
      decideSigns(soup, found);
      found.solidVolume = solidVolumeOf(soup, found);
    }
    found.defects = detail::findDefects(soup, mesh, found);
  }
  if (!options.tryTreatments) return found;
  watch.lap();
  if (!found.defects.empty()) {
    begin("trying repairs");
    auto [treatments, openings] = detail::findTreatments(soup, options.fillHoles);
    found.treatments = std::move(treatments);
    found.openings = std::move(openings);
  }
  found.seconds.treatments = watch.lap();
  found.wrapGap = wrapGapOf(soup, found);
  return found;
}

}  // namespace cutwater
