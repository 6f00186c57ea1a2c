#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/CellTagger.hpp>
#include <Cutwater/Grid/Detail/FacetRules.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
CellTagger<T>::CellTagger(const SignedDistanceFunction<T>& solid, const Refinement<T>& refinement)
    : solid_(solid), refinement_(refinement), promise_(solid.guarantee()) {
  refinement.check();
}

template <std::floating_point T>
T CellTagger<T>::reachOf(int level) const {
  T reach = -1;
  for (const auto& band : refinement_.bands) {
    if (band.level > level) reach = std::max(reach, band.distance);
  }
  return reach;
}

template <std::floating_point T>
void CellTagger<T>::tag(int level, std::span<const Box<T>> cells, std::span<BoxHint> hints,
                        std::span<CellTag> tags) const {
  FacetRules<T> rules(solid_, refinement_);
  Scratch<BoxClass, kMost> kinds;
  solid_.classify(cells, kinds.first(cells.size()), hints, {.threads = 1});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto& [kind, isRefined] = tags[i];
    kind = kinds[i];
    isRefined = mayBeCut(kind) && level < refinement_.cut;
  }
  if (rules.concern(level)) rules.tag(level, cells, tags.first(cells.size()));
  if (const T reach = reachOf(level); reach >= 0) tagNear(reach, cells, hints, tags);
}

template <std::floating_point T>
void CellTagger<T>::tag(const Cells& cells, std::span<CellTag> tags,
                        const ParallelOptions& options) const {
  parallelBatches(cells.codes.size(), kMost,
                  {.threads = options.threads, .progress = options.progress},
                  [&](std::size_t first, std::size_t count) {
                    Scratch<Box<T>, kMost> boxes;
                    Scratch<BoxHint, kMost> scratch;
                    const auto hints = scratch.first(count);
                    cells.hintsBefore(first, hints);
                    for (std::size_t i = 0; i < count; ++i) {
                      boxes[i] = cells.grid.cell(indexOf(cells.codes[first + i]));
                    }
                    tag(cells.level, boxes.first(count), hints, tags.subspan(first, count));
                    cells.hintsAfter(first, hints);
                  });
}

template <std::floating_point T>
void CellTagger<T>::tagNear(T reach, std::span<const Box<T>> cells, std::span<BoxHint> hints,
                            std::span<CellTag> tags) const {
  Scratch<Vec3<T>, kMost> centers;
  Scratch<T, kMost> values;
  Scratch<std::size_t, kMost> open;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (tags[i].isRefined) continue;
    centers[count] = cells[i].center();
    open[count++] = i;
  }
  solid_.signedDistances(centers.first(count), values.first(count), {.threads = 1});
  for (std::size_t n = 0; n < count; ++n) {
    const auto i = open[n];
    tags[i].isRefined = isNear(reach, cells[i], values[n], hints[i]);
  }
}

template <std::floating_point T>
bool CellTagger<T>::isNear(T reach, const Box<T>& cell, T atCenter, BoxHint& hint) const {
  const auto box = OrientedBox<T>::of(cell);
  if (promise_.lipschitz && box.isWithin(promise_.domain)) {
    // The value in the middle decides most.
    const auto range = boundsAround(atCenter, box, promise_);
    if (distanceRange(range, promise_).lower > reach) return false;
    const auto here = distanceRange({atCenter, atCenter}, promise_);
    if (here.upper + promise_.error(length(box.center)) <= reach) return true;
  }
  return solid_.distanceBounds(cell, &hint).lower <= reach;
}

template class CellTagger<float>;
template class CellTagger<double>;

}  // namespace cutwater::detail
