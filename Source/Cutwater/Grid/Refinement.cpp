#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/FacetRules.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

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

template <std::floating_point T>
CellJudge<T>::CellJudge(const SignedDistanceFunction<T>& solid, const Refinement<T>& refinement)
    : solid_(solid), refinement_(refinement), promise_(solid.guarantee()) {
  refinement.check();
}

template <std::floating_point T>
T CellJudge<T>::reachOf(int level) const {
  T reach = -1;
  for (const auto& band : refinement_.bands) {
    if (band.level > level) reach = std::max(reach, band.distance);
  }
  return reach;
}

template <std::floating_point T>
void CellJudge<T>::judge(int level, std::span<const Box<T>> cells, std::span<BoxHint> hints,
                         std::span<CellVerdict> verdicts) const {
  detail::FacetRules<T> rules(solid_, refinement_);
  Scratch<BoxClass, kMost> kinds;
  solid_.classify(cells, kinds.first(cells.size()), hints, {.threads = 1});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto& [kind, isRefined] = verdicts[i];
    kind = kinds[i];
    isRefined = mayBeCut(kind) && level < refinement_.cut;
  }
  if (rules.matter(level)) rules.ask(level, cells, verdicts.first(cells.size()));
  if (const T reach = reachOf(level); reach >= 0) judgeNearness(reach, cells, hints, verdicts);
}

template <std::floating_point T>
void CellJudge<T>::judge(const Cells& cells, std::span<CellVerdict> verdicts,
                         const ParallelOptions& options) const {
  parallelFor(cells.codes.size(),
              {.threads = options.threads, .grain = kMost, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (; begin < end; begin += kMost) {
                  Scratch<Box<T>, kMost> boxes;
                  Scratch<BoxHint, kMost> scratch;
                  const auto hints = scratch.first(std::min(kMost, end - begin));
                  cells.hintsBefore(begin, hints);
                  for (std::size_t i = 0; i < hints.size(); ++i) {
                    boxes[i] = cells.grid.cell(indexOf(cells.codes[begin + i]));
                  }
                  judge(cells.level, boxes.first(hints.size()), hints,
                        verdicts.subspan(begin, hints.size()));
                  cells.hintsAfter(begin, hints);
                }
              });
}

template <std::floating_point T>
void CellJudge<T>::judgeNearness(T reach, std::span<const Box<T>> cells, std::span<BoxHint> hints,
                                 std::span<CellVerdict> verdicts) const {
  Scratch<Vec3<T>, kMost> centers;
  Scratch<T, kMost> values;
  Scratch<std::size_t, kMost> open;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (verdicts[i].isRefined) continue;
    centers[count] = cells[i].center();
    open[count++] = i;
  }
  solid_.signedDistances(centers.first(count), values.first(count), {.threads = 1});
  for (std::size_t n = 0; n < count; ++n) {
    const auto i = open[n];
    verdicts[i].isRefined = isNear(reach, cells[i], values[n], hints[i]);
  }
}

template <std::floating_point T>
bool CellJudge<T>::isNear(T reach, const Box<T>& cell, T atCenter, BoxHint& hint) const {
  const auto box = OrientedBox<T>::of(cell);
  if (promise_.lipschitz && box.isWithin(promise_.domain)) {
    // The value in the middle decides most.
    const auto range = detail::boundsAround(atCenter, box, promise_);
    if (detail::distanceRange(range, promise_).lower > reach) return false;
    const auto here = detail::distanceRange({atCenter, atCenter}, promise_);
    if (here.upper + promise_.error(length(box.center)) <= reach) return true;
  }
  return solid_.distanceBounds(cell, &hint).lower <= reach;
}

template struct Refinement<float>;
template struct Refinement<double>;
template class CellJudge<float>;
template class CellJudge<double>;

}  // namespace cutwater
