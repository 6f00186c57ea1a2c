#include <Cutwater/Mesh/Detail/DefectSearch.hpp>
#include <Cutwater/Mesh/Detail/PlanarOpenings.hpp>
#include <Cutwater/Mesh/Detail/TreatmentSearch.hpp>
#include <Cutwater/Mesh/Detail/TreatmentTrial.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Text/Numbers.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cutwater::detail {

namespace {

using text::grouped;
using text::rounded;

/// The number with the fewest digits within `tolerance` of the value.
double roundedWithin(double value, double tolerance) {
  if (std::abs(value) <= tolerance) return 0;
  for (int digits = 1; digits <= 17; ++digits) {
    const double shorter = rounded(value, digits);
    if (std::abs(shorter - value) <= tolerance) return shorter;
  }
  return value;
}

class TreatmentSearch {
 public:
  TreatmentSearch(const PolygonSoup& soup, const HoleFilling& fillHoles)
      : soup_(soup),
        fillHoles_(fillHoles),
        diagonal_(soup.boundingBox().diagonal()),
        planar_(1e-4 * diagonal_),
        best_(tried(Treatment{}).value()) {}

  FoundTreatments run() {
    closeGaps(&CleanOptions::weldWithin, [this](double tolerance) {
      PolygonSoup rims;
      rims.points = rimPoints();
      return static_cast<bool>(weldWithin(rims, tolerance));
    });
    closeGaps(&CleanOptions::splitJunctionsWithin, [this](double tolerance) {
      PolygonSoup copy = best_.soup;
      return static_cast<bool>(splitJunctions(copy, tolerance));
    });
    auto rims = findRims(best_.soup);
    std::ranges::stable_sort(rims, std::ranges::greater{},
                             [](const Rim& rim) { return rim.box.diagonal(); });
    for (const auto& rim : rims) {
      result_.openings.push_back({rim.points.size(), rim.box, planeOf(rim, planar_)});
    }
    if (!rims.empty() && !flatAxis(best_.soup)) closeOpenings(rims);
    fillHoles();
    if (result_.treatments.empty()) suggestCleaning();
    return std::move(result_);
  }

 private:
  /// Adopts the smallest tolerance that leaves the fewest gaps, if it is worth it. Tolerances that
  /// `mayHelp` rules out are not tried.
  template <typename MayHelp>
  void closeGaps(std::optional<double> CleanOptions::*tolerance, MayHelp mayHelp) {
    const TreatmentTrial before = best_;
    for (const double share : {1e-7, 1e-6, 1e-5, 1e-4}) {
      if (best_.gaps() == 0 || diagonal_ == 0) return;
      const double length = roundedWithin(share * diagonal_, 0.1 * share * diagonal_);
      if (!mayHelp(length)) continue;
      auto treatment = before.treatment;
      treatment.clean.*tolerance = length;
      auto trial = tried(treatment);
      if (!trial || trial->gaps() >= best_.gaps() || !isWorthIt(*trial, before)) continue;
      if (keepsItsShape(trial->report, before.report)) best_ = *std::move(trial);
    }
  }

  /// Whether at most half of the gaps remain, or nothing but openings in planes, for caps to close.
  [[nodiscard]] bool isWorthIt(const TreatmentTrial& trial, const TreatmentTrial& before) const {
    if (2 * trial.gaps() <= before.gaps()) return true;
    const auto isPlane = [&](const Rim& rim) { return planeOf(rim, planar_).has_value(); };
    return std::ranges::all_of(findRims(trial.soup), isPlane) &&
           !std::ranges::all_of(findRims(before.soup), isPlane);
  }

  /// The points of all rims, each once.
  [[nodiscard]] std::vector<Vec3<double>> rimPoints() const {
    std::vector<std::uint32_t> numbers;
    for (const auto& rim : findRims(best_.soup)) {
      numbers.insert(numbers.end(), rim.points.begin(), rim.points.end());
    }
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Vec3<double>> points;
    for (const auto i : numbers) points.push_back(best_.soup.points[i]);
    return points;
  }

  /// Whether details survive: tolerances beyond their size would destroy them.
  [[nodiscard]] static bool keepsItsShape(const MeshReport& after, const MeshReport& before) {
    constexpr double kLost = 1e-3;
    return std::abs(after.area - before.area) <= kLost * before.area;
  }

  void closeOpenings(const std::vector<Rim>& rims) {
    const auto planes = planarOpenings(rims, planar_);
    if (planes.empty()) {
      if (rims.size() == 1) extend();
      return;
    }
    cap(planes);
    const auto& plane = planes.front();
    if (plane.rims < rims.size() || !mayBeHalf(plane)) return;
    const auto whole = tried(with(best_.treatment, ClosingKind::Mirror, plane));
    if (whole && whole->gaps() == 0) suggest(*whole);
  }

  /// Whether the openings may be those of a half model: in a plane at its end, and as long as the
  /// model.
  [[nodiscard]] bool mayBeHalf(const PlanarOpenings& openings) const {
    if (openings.spread > 1e-5 * diagonal_) return false;  // points would be moved onto the plane
    const auto box = best_.soup.boundingBox();
    const auto [axis, at] = openings.plane;
    const double away = std::min(std::abs(at - box.lower[axis]), std::abs(at - box.upper[axis]));
    const auto size = openings.box.size();
    return away <= 2 * planar_ && 2 * maxComponent(size) >= maxComponent(box.size());
  }

  /// The treatment with one more closing, and with a tolerance only where rims need one.
  [[nodiscard]] static Treatment with(Treatment treatment, ClosingKind kind,
                                      const PlanarOpenings& openings) {
    auto plane = openings.plane;
    if (openings.spread > 0) {
      plane.at = roundedWithin(plane.at, openings.spread);
      const double needed = openings.spread + std::abs(plane.at - openings.plane.at);
      treatment.tolerance =
          std::max(treatment.tolerance, roundedWithin(1.5 * needed, 0.4 * needed));
    }
    treatment.closings.push_back({kind, plane});
    return treatment;
  }

  /// Adds caps in as many planes as it takes, each only if it closes something.
  void cap(const std::vector<PlanarOpenings>& planes) {
    constexpr std::size_t kMostPlanes = 6;
    std::optional<TreatmentTrial> capped;
    for (const auto& openings : planes) {
      const auto& now = capped ? *capped : best_;
      if (now.treatment.closings.size() == kMostPlanes) break;
      auto trial = tried(with(now.treatment, ClosingKind::Cap, openings));
      if (!trial || trial->gaps() >= now.gaps()) continue;
      if (!foldsBack(*trial, now)) capped = std::move(trial);
    }
    if (capped && 2 * capped->gaps() <= best_.gaps()) suggest(*capped);
  }

  /// Whether caps only repeat existing faces from behind: the openings are then those of sheets.
  [[nodiscard]] static bool foldsBack(const TreatmentTrial& capped, const TreatmentTrial& before) {
    if (capped.report.oppositeFaces.count > before.report.oppositeFaces.count) return true;
    const DcelMesh<double> mesh(capped.soup);
    const auto first = static_cast<std::uint32_t>(before.soup.polygonCount());
    std::size_t rimEdges = 0;
    std::size_t folds = 0;
    for (std::uint32_t i = first; i < mesh.faces().size(); ++i) {
      for (const FaceId beside : mesh.neighbours(FaceId{i})) {
        if (beside == kNoFace || index(beside) >= first) continue;
        ++rimEdges;
        if (dot(mesh.normal(FaceId{i}), mesh.normal(beside)) < -0.999) ++folds;
      }
    }
    return 2 * folds > rimEdges;
  }

  /// Extends a sheet whose faces all point to one side along an axis, such as a terrain, to a solid
  /// as deep again as it is high.
  void extend() {
    const auto axis = axisSeen();
    if (!axis) return;
    const auto box = best_.soup.boundingBox();
    const double depth = std::max(box.size()[*axis], 0.05 * diagonal_);
    const double level = roundedWithin(box.lower[*axis] - depth, 0.25 * depth);
    auto treatment = best_.treatment;
    treatment.closings.push_back({ClosingKind::Extend, {*axis, level}});
    const auto extended = tried(treatment);
    if (extended && extended->gaps() == 0) suggest(*extended);
  }

  /// The axis, z first, along which all faces point to the same side.
  [[nodiscard]] std::optional<int> axisSeen() const {
    const DcelMesh<double> mesh(best_.soup);
    for (const int axis : {2, 1, 0}) {
      bool isUp = false;
      bool isDown = false;
      for (const FaceId face : mesh.faces()) {
        const double n = mesh.normal(face)[axis];
        isUp = isUp || n >= 0;
        isDown = isDown || n <= 0;
      }
      if (isUp != isDown) return axis;
    }
    return {};
  }

  /// Fills the holes that remain after cleaning, or else after the first repair found.
  void fillHoles() {
    const bool isDone = !result_.treatments.empty() && result_.treatments.front().isClosed;
    if (!fillHoles_ || best_.gaps() == 0 || isDone || flatAxis(best_.soup)) return;
    auto treatment = result_.treatments.empty() ? best_.treatment : result_.treatments.front();
    const double widest = 0.3 * diagonal_;  // beyond, a flat patch is hardly intended
    treatment.widestHole = roundedWithin(widest, 0.1 * widest);
    const auto filled = tried(treatment);
    if (!filled || 2 * filled->gaps() > best_.gaps()) return;
    result_.treatments.clear();
    suggest(*filled);
  }

  void suggestCleaning() {
    const auto trial = withoutDebris(best_);
    if (!trial.effects.empty()) add(trial);
  }

  /// A few pairs of opposite faces may be all that keeps a closed surface from bounding a solid:
  /// they are debris then, and are cancelled. Many are panels.
  [[nodiscard]] TreatmentTrial withoutDebris(const TreatmentTrial& trial) const {
    const MeshReport& report = trial.report;
    const bool mayBeDebris = trial.gaps() == 0 && !report.isClosedOriented() &&
                             report.oppositeFaces &&
                             100 * report.oppositeFaces.count <= report.faces;
    if (!mayBeDebris) return trial;
    auto treatment = trial.treatment;
    treatment.clean.opposite = OppositeFaces::Cancel;
    auto without = tried(treatment);
    const bool isBetter =
        without && without->report.isClosedOriented() && keepsItsShape(without->report, report);
    return isBetter ? *std::move(without) : trial;
  }

  void suggest(const TreatmentTrial& trial) { add(withoutDebris(trial)); }

  void add(const TreatmentTrial& trial) {
    if (trial.report.faces == 0) return;  // nothing would be left to write
    Treatment treatment = trial.treatment;
    treatment.effect.clear();
    treatment.isClosed = trial.gaps() == 0;
    for (const auto& [what, count] : trial.effects) {
      if (!treatment.effect.empty()) treatment.effect += ", ";
      treatment.effect += what + ": " + grouped(count);
    }
    const auto left = trial.report.boundaryEdges.count;
    const auto excess = trial.report.nonManifoldEdges.count;
    treatment.effect += treatment.isClosed && excess > 0
                            ? "; closed then, with " + grouped(excess, "non-manifold edge")
                        : treatment.isClosed ? "; closed then"
                        : left > 0           ? "; leaves " + grouped(left, "open edge")
                                             : "; leaves non-manifold edges that count as open";
    result_.treatments.push_back(std::move(treatment));
  }

  [[nodiscard]] std::optional<TreatmentTrial> tried(const Treatment& treatment) const {
    return detail::tried(soup_, treatment, fillHoles_);
  }

  const PolygonSoup& soup_;
  const HoleFilling& fillHoles_;
  double diagonal_;
  double planar_;  // within which rims count as plane
  TreatmentTrial best_;
  FoundTreatments result_;
};

}  // namespace

FoundTreatments findTreatments(const PolygonSoup& soup, const HoleFilling& fillHoles) {
  return TreatmentSearch(soup, fillHoles).run();
}

}  // namespace cutwater::detail
