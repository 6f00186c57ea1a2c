#include <Cutwater/Scene/Detail/SceneForm.hpp>

namespace cutwater::scene {

const std::vector<SceneForms>& allSceneForms() {
  static const std::vector<SceneForms> kAll{
      {"Shapes", "The value of `shape` says which one it is. Angles are in degrees.", shapeForms()},
      {"Surfaces", "Names of files are relative to the scene's folder.", surfaceForms()},
      {"Lattices and beds", "Cells begin at the origin; `move` moves the whole lattice.",
       latticeForms()},
      {"Triply periodic surfaces",
       "They have no end: intersect them with the solid that they fill. [Docs/tpms.md](tpms.md) "
       "describes the patterns F and the parts.",
       tpmsForms()},
      {"Operators", "They take other solids by name, which may stand anywhere in the file.",
       operatorForms()},
  };
  return kAll;
}

}  // namespace cutwater::scene
