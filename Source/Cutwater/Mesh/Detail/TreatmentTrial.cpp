#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/TreatmentTrial.hpp>

namespace cutwater::detail {

std::optional<TreatmentTrial> tried(const PolygonSoup& soup, const Treatment& treatment,
                                    const HoleFilling& fillHoles) {
  TreatmentTrial trial{.treatment = treatment, .soup = soup, .report = {}, .effects = {}};
  try {
    trial.effects = treat(trial.soup, treatment, fillHoles);
  } catch (const Error&) {
    return {};
  }
  trial.report = check(DcelMesh<double>(trial.soup));
  return trial;
}

}  // namespace cutwater::detail
