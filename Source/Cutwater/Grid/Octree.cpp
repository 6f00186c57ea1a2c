#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/OctreeBuilder.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

template <std::floating_point T>
OctreeCells<T> builtCells(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                          const Refinement<T>& refinement, const OctreeOptions& options) {
  const detail::CellTagger<T> tagger(solid, refinement);
  const int deepest = refinement.deepest();
  detail::requireLevel(domain, deepest);
  return {domain, deepest, detail::OctreeBuilder<T>(tagger, domain, options).run(deepest)};
}

}  // namespace

template <std::floating_point T>
Octree<T>::Octree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                  const Refinement<T>& refinement, const OctreeOptions& options)
    : OctreeCells<T>(builtCells(solid, domain, refinement, options)) {}

template <std::floating_point T>
std::optional<std::size_t> Octree<T>::find(const Index3& index, int level) const {
  if (!this->domain().indices(level).contains(index)) return {};
  // Codes of the first cell in each, on a level as fine as that of any cell.
  const int finest = std::max(level, this->deepest());
  const auto placeOf = [=](const OctreeCell& cell) { return detail::placeOf(cell, finest); };
  const auto place = detail::mortonCode(index) << 3 * (finest - level);
  const auto cells = this->cells();
  const auto after = std::ranges::upper_bound(cells, place, {}, placeOf);
  return static_cast<std::size_t>(after - cells.begin()) - 1;
}

template <std::floating_point T>
std::optional<std::size_t> Octree<T>::find(const Vec3<T>& point) const {
  if (!isFinite(point)) return {};
  const auto level = this->domain().level(this->deepest());
  const auto& origin = this->domain().origin();
  const auto along = [&](T x, T first) { return std::floor((x - first) / level.spacing().x); };
  const Vec3<T> place{along(point.x, origin.x), along(point.y, origin.y), along(point.z, origin.z)};
  constexpr T kMost = T(1 << detail::kMortonBits);
  if (!(maxComponent(abs(place)) <= kMost)) return {};
  const Index3 index{static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y),
                     static_cast<std::int32_t>(place.z)};
  // Both the quotient and the faces are rounded, so the index may be off by one.
  const auto box = level.cell(index);
  const auto step = [&](int axis) {
    return point[axis] < box.lower[axis] ? -1 : point[axis] >= box.upper[axis] ? 1 : 0;
  };
  return find({index.i + step(0), index.j + step(1), index.k + step(2)}, this->deepest());
}

template class Octree<float>;
template class Octree<double>;

}  // namespace cutwater
