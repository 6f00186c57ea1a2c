#include <Cutwater/Io/Scene/SceneForm.hpp>

namespace cutwater::scene {

const std::vector<SceneForms>& allSceneForms() {
  static const std::vector<SceneForms> kAll{
      {"Shapes", "Known by the value of `shape`. Angles are in degrees.", shapeForms()},
      {"Surfaces", "Names of files are relative to the scene's.", surfaceForms()},
      {"Lattices and beds", "Cells begin at the origin; `move` moves the whole.", latticeForms()},
      {"Operators", "Of solids by name, wherever in the file these are.", operatorForms()},
  };
  return kAll;
}

}  // namespace cutwater::scene
