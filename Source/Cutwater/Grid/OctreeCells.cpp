#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
OctreeCells<T>::OctreeCells(const OctreeDomain<T>& domain, int deepest,
                            std::vector<OctreeCell> cells)
    : domain_(domain), cells_(std::move(cells)) {
  require(0 <= deepest && deepest <= domain.deepest(),
          "OctreeCells: need a level from 0 to the finest possible", Named{"level", deepest},
          Named{"finest possible", domain.deepest()});
  for (int level = 0; level <= deepest; ++level) levels_.push_back(domain.level(level));
  detail::MortonCode end = 0;
  for (std::size_t n = 0; n < cells_.size(); ++n) {
    const auto& cell = cells_[n];
    require(cell.level <= deepest && domain.indices(cell.level).contains(cell.index),
            "OctreeCells: need cells within the domain, no finer than its finest",
            Named{"cell", n});
    const auto place = detail::placeOf(cell, deepest);
    require(place >= end, "OctreeCells: need cells in the order of their codes, without overlap",
            Named{"cell", n});
    end = place + (detail::MortonCode{1} << 3 * (deepest - cell.level));
  }
}

template <std::floating_point T>
std::size_t OctreeCells<T>::count(BoxClass kind) const {
  return static_cast<std::size_t>(std::ranges::count(cells_, kind, &OctreeCell::kind));
}

template class OctreeCells<float>;
template class OctreeCells<double>;

}  // namespace cutwater
