#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Detail/PointMerging.hpp>

#include <utility>

namespace cutwater {
namespace {

Correction weldEqual(PolygonSoup& soup) {
  auto firsts = detail::firstEqualPoints(soup.points);
  Correction correction;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    if (firsts[i] != i) correction.add(soup.points[i]);
  }
  detail::mergePoints(soup, firsts);
  return correction;
}

class Cleaner {
 public:
  Cleaner(PolygonSoup& soup, const CleanOptions& options)
      : soup_(soup), options_(options), now_(measure(soup)) {}

  CleanReport run() {
    note(CleanKind::EqualPoints, weldEqual(soup_));
    if (options_.weldWithin) {
      note(CleanKind::ClosePoints, weldWithin(soup_, *options_.weldWithin));
    }
    while (mendFaces()) listAll_ = false;
    listAll_ = true;
    note(CleanKind::UnusedPoints, removeUnusedPoints(soup_));
    if (options_.orient) orient();
    return std::move(report_);
  }

 private:
  /// Returns whether there may be edges left that have to be checked again.
  bool mendFaces() {
    const bool degenerate = note(CleanKind::DegenerateFaces, removeDegenerateFaces(soup_));
    bool equal = note(CleanKind::DuplicateFaces, removeDuplicateFaces(soup_));
    if (options_.opposite == OppositeFaces::Cancel) {
      equal = note(CleanKind::OppositeFaces, cancelOppositeFaces(soup_)) || equal;
    }
    if (!options_.splitJunctionsWithin) return false;
    const bool split =
        note(CleanKind::Junctions, splitJunctions(soup_, *options_.splitJunctionsWithin));
    return degenerate || equal || split;
  }

  void orient() {
    const auto found = orientFaces(soup_, options_.nested);
    note(CleanKind::TurnedFaces, found.faces);
    note(CleanKind::TurnedShells, found.shells);
    Correction unorientable;
    unorientable.places.count = found.unorientable;
    if (found.unorientable > 0) note(CleanKind::UnorientableShells, unorientable);
  }

  /// Adds a step to the report, unless it is a repeated one that found nothing.
  bool note(CleanKind kind, const Correction& correction) {
    const bool found{correction};
    const SurfaceMeasure before = now_;
    if (found) now_ = measure(soup_);
    if (found || listAll_) report_.steps.push_back({kind, correction, before, now_});
    return found;
  }

  PolygonSoup& soup_;
  const CleanOptions& options_;
  SurfaceMeasure now_;
  bool listAll_ = true;
  CleanReport report_;
};

}  // namespace

CleanReport clean(PolygonSoup& soup, const CleanOptions& options) {
  soup.validate();
  PolygonSoup work = soup;
  auto report = Cleaner(work, options).run();
  if (!report.changedNothing()) soup = std::move(work);
  return report;
}

}  // namespace cutwater
