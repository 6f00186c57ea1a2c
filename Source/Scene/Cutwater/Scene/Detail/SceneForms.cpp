#include <Cutwater/Scene/Detail/SceneForm.hpp>

namespace cutwater::scene {

const std::vector<SceneForms>& allSceneForms() {
  static const std::vector<SceneForms> kAll{
      {"Shapes", "Known by the value of `shape`. Angles are in degrees.", shapeForms()},
      {"Surfaces", "Names of files are relative to the scene's.", surfaceForms()},
      {"Lattices and beds", "Cells begin at the origin; `move` moves the whole.", latticeForms()},
      {"Triply periodic surfaces",
       "Endless: intersect them with what they fill. [Docs/tpms.md](tpms.md) has the patterns F "
       "and "
       "what their parts are.",
       tpmsForms()},
      {"Operators", "Of solids by name, wherever in the file these are.", operatorForms()},
  };
  return kAll;
}

}  // namespace cutwater::scene
