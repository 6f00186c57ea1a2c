#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Refinement.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

template <std::floating_point T>
int Refinement<T>::deepest() const {
  int level = cut;
  const auto add = [&level](const auto& rules) {
    for (const auto& rule : rules) level = std::max(level, rule.level);
  };
  add(bands);
  add(patches);
  for (const auto& rule : {curvature, edges}) level = std::max(level, rule ? rule->level : 0);
  for (const auto& rule : {gaps, walls}) level = std::max(level, rule ? rule->level : 0);
  return level;
}

template <std::floating_point T>
void Refinement<T>::check() const {
  const auto checkLevel = [](const char* what, int level) {
    require(level >= 0, "Refinement: need levels >= 0", Named{what, level});
  };
  const auto checkSize = [](const char* what, T size) {
    require(size >= 0 && std::isfinite(size), "Refinement: need finite distances and widths >= 0",
            Named{what, size});
  };
  checkLevel("cut", cut);
  for (const auto& band : bands) {
    checkLevel("band level", band.level);
    checkSize("band distance", band.distance);
  }
  for (const auto& rule : patches) checkLevel("patch level", rule.level);
  for (const auto& rule : {curvature, edges}) {
    if (!rule) continue;
    checkLevel("angle level", rule->level);
    require(rule->degrees > 0 && rule->degrees < 180, "Refinement: need angles within (0, 180)",
            Named{"degrees", rule->degrees});
  }
  for (const auto& rule : {gaps, walls}) {
    if (!rule) continue;
    checkLevel("width level", rule->level);
    checkSize("cells", rule->cells);
  }
}

template struct Refinement<float>;
template struct Refinement<double>;

}  // namespace cutwater
