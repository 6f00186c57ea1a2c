#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeBuilder.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

template <std::floating_point T>
Octree<T>::Octree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                  const Refinement<T>& refinement, const OctreeOptions& options)
    : domain_(domain) {
  const CellJudge<T> judge(solid, refinement);
  const int deepest = refinement.deepest();
  require(deepest <= domain.deepest(), "Octree: need fewer levels for so many roots",
          Named{"level", deepest}, Named{"finest possible", domain.deepest()});
  for (int level = 0; level <= deepest; ++level) levels_.push_back(domain.level(level));
  cells_ = detail::OctreeBuilder<T>(judge, domain, options).run(deepest);
}

template <std::floating_point T>
std::size_t Octree<T>::count(BoxClass kind) const {
  return static_cast<std::size_t>(std::ranges::count(cells_, kind, &OctreeCell::kind));
}

template <std::floating_point T>
std::optional<std::size_t> Octree<T>::find(const Index3& index, int level) const {
  const auto& n = domain_.indices(level).hi;
  if (index.i < 0 || index.j < 0 || index.k < 0 || index.i > n.i || index.j > n.j ||
      index.k > n.k) {
    return {};
  }
  // Codes on a level that all cells have, of the first cell in each.
  const int finest = std::max(level, deepest());
  const auto placeOf = [&](const OctreeCell& cell) {
    return mortonCode(cell.index) << 3 * (finest - cell.level);
  };
  const auto place = mortonCode(index) << 3 * (finest - level);
  const auto after = std::ranges::upper_bound(cells_, place, {}, placeOf);
  return static_cast<std::size_t>(after - cells_.begin()) - 1;
}

template <std::floating_point T>
std::optional<std::size_t> Octree<T>::find(const Vec3<T>& point) const {
  const auto& level = levels_.back();
  const auto along = [&](T x, T origin) { return std::floor((x - origin) / level.spacing().x); };
  const Vec3<T> place{along(point.x, domain_.origin().x), along(point.y, domain_.origin().y),
                      along(point.z, domain_.origin().z)};
  constexpr T kMost = T(1 << kMortonBits);
  if (!(maxComponent(abs(place)) < kMost)) return {};
  return find({static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y),
               static_cast<std::int32_t>(place.z)},
              deepest());
}

template class Octree<float>;
template class Octree<double>;

}  // namespace cutwater
