#include "Trial.hpp"

#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <variant>

namespace cutwater::tool {

namespace {

void add(Effects& effects, const std::string& what, std::size_t count) {
  if (count == 0) return;
  const auto same = std::ranges::find(effects, what, &Effects::value_type::first);
  if (same == effects.end()) {
    effects.emplace_back(what, count);
  } else {
    same->second += count;
  }
}

void addEffects(Effects& effects, const CleanReport& report) {
  for (const auto& step : report.steps) {
    if (step.kind == CleanKind::UnorientableShells) continue;
    add(effects, nameOf(step.kind), step.correction.places.count);
  }
}

void addEffects(Effects& effects, const OpeningReport& report) {
  add(effects, "openings closed", report.closed.count);
  if (!report.closed) add(effects, "edges joined with the mirror image", report.rimEdges);
}

#ifdef CUTWATER_HAS_REPAIR
void addEffects(Effects& effects, const HoleReport& report) {
  add(effects, "holes filled", report.filled.count);
}
void addEffects(Effects& effects, const SelfIntersectionRepairReport& report) {
  add(effects, "pairs of faces apart", report.pairsBefore - report.pairsAfter);
}
void addEffects(Effects& effects, const WrapReport& report) {
  add(effects, "faces of the wrap", report.facesAfter);
}
#endif

}  // namespace

std::optional<Trial> tried(const PolygonSoup& soup, const RepairOptions& options) {
  Trial trial{.soup = soup, .options = options, .report = {}, .effects = {}};
  try {
    for (const auto& step : stepsOf(options)) {
      const auto report = step.run(trial.soup);
      std::visit([&](const auto& r) { addEffects(trial.effects, r); }, report);
    }
  } catch (const Error&) {
    return {};
  }
  trial.report = check(DcelMesh<double>(trial.soup));
  return trial;
}

}  // namespace cutwater::tool
