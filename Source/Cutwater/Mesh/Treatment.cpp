#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// What the steps did, each kind of effect once.
class Effects {
 public:
  void add(const std::string& what, std::size_t count) {
    if (count == 0) return;
    const auto same = std::ranges::find(effects_, what, &TreatmentEffect::what);
    if (same == effects_.end()) {
      effects_.push_back({what, count});
    } else {
      same->count += count;
    }
  }

  void add(const CleanReport& report) {
    for (const auto& step : report.steps) {
      if (step.kind == CleanKind::UnorientableShells) continue;
      add(nameOf(step.kind), step.correction.places.count);
    }
  }

  void add(const OpeningReport& report) {
    add("openings closed", report.closed.count);
    if (!report.closed) add("edges joined with the mirror image", report.rimEdges);
  }

  std::vector<TreatmentEffect> take() && { return std::move(effects_); }

 private:
  std::vector<TreatmentEffect> effects_;
};

OpeningReport close(PolygonSoup& soup, const PlaneClosing& closing, double tolerance) {
  const auto [axis, at] = closing.plane;
  if (closing.kind == ClosingKind::Extend) return extendTo(soup, axis, at);
  SurfacePlane plane;
  plane.point[axis] = at;
  plane.normal[axis] = 1;
  if (closing.kind == ClosingKind::Mirror) return mirrorAt(soup, plane, tolerance);
  return capOnPlane(soup, plane, {.tolerance = tolerance});
}

}  // namespace

std::vector<TreatmentEffect> treat(PolygonSoup& soup, const Treatment& treatment,
                                   const HoleFilling& fillHoles) {
  require(!treatment.widestHole || fillHoles, "treat: need a function that fills holes");
  Effects effects;
  effects.add(clean(soup, treatment.clean));
  for (const auto& closing : treatment.closings) {
    effects.add(close(soup, closing, treatment.tolerance));
  }
  if (treatment.widestHole) effects.add("holes filled", fillHoles(soup, *treatment.widestHole));
  return std::move(effects).take();
}

}  // namespace cutwater
