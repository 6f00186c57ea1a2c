#include <Cutwater/Grid/Detail/FacetRules.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutwater::detail {

namespace {

template <std::floating_point T>
T radians(T degrees) {
  return degrees * (std::numbers::pi_v<T> / 180);
}

}  // namespace

template <std::floating_point T>
void DirectionSpread<T>::add(const Vec3<T>& d) {
  const T root2 = std::sqrt(T(0.5));
  const T root3 = std::sqrt(T(1) / 3);
  const std::array<T, kAxes> along{d.x,
                                   d.y,
                                   d.z,
                                   root2 * (d.x + d.y),
                                   root2 * (d.x - d.y),
                                   root2 * (d.y + d.z),
                                   root2 * (d.y - d.z),
                                   root2 * (d.z + d.x),
                                   root2 * (d.z - d.x),
                                   root3 * (d.x + d.y + d.z),
                                   root3 * (d.x + d.y - d.z),
                                   root3 * (d.x - d.y + d.z),
                                   root3 * (d.x - d.y - d.z)};
  for (std::size_t i = 0; i < kAxes; ++i) {
    least_[i] = empty_ ? along[i] : std::min(least_[i], along[i]);
    most_[i] = empty_ ? along[i] : std::max(most_[i], along[i]);
  }
  empty_ = false;
}

template <std::floating_point T>
T DirectionSpread<T>::bound() const {
  T widest = 0;
  for (std::size_t i = 0; i < kAxes; ++i) widest = std::max(widest, most_[i] - least_[i]);
  // The direction farthest from all axes lies between (1, 0, 0), (1, 1, 0) and (1, 1, 1), at (1,
  // sqrt(2) - 1, sqrt(3) - sqrt(2)): its component along each is 0.8864 of its length.
  constexpr T kLeastCosine = T(0.8864);
  return widest / kLeastCosine;
}

template <std::floating_point T>
FacetRules<T>::FacetRules(const SignedDistanceFunction<T>& solid, const Refinement<T>& rules)
    : solid_(solid), rules_(rules) {
  if (rules.curvature) mostTurn_ = 2 * std::sin(radians(rules.curvature->degrees) / 2);
  if (rules.edges) sharpest_ = std::cos(radians(rules.edges->degrees));
}

template <std::floating_point T>
bool FacetRules<T>::concern(int level) const {
  const auto applies = [level](const auto& rule) { return rule && level < rule->level; };
  return std::ranges::any_of(rules_.patches, [level](const auto& r) { return level < r.level; }) ||
         applies(rules_.curvature) || applies(rules_.edges) || applies(rules_.gaps) ||
         applies(rules_.walls);
}

template <std::floating_point T>
void FacetRules<T>::tag(int level, std::span<const Box<T>> cells, std::span<CellTag> tags) {
  const T reach = reachOf(level);
  surroundings_ = {};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!isOpen(tags[i])) continue;
    auto& isRefined = tags[i].isRefined;
    isRefined = applyWithin(level, cells[i]);
    if (isRefined || reach < 0 || own_.empty()) continue;
    own_.build();
    lookAround(reach, cells.subspan(i), tags.subspan(i));
    isRefined = isNarrow(rules_.gaps, Facing::Fronts, level, cells[i]) ||
                isNarrow(rules_.walls, Facing::Backs, level, cells[i]);
  }
}

template <std::floating_point T>
bool FacetRules<T>::applyWithin(int level, const Box<T>& cell) {
  own_.clear();
  spread_ = {};
  bool applies = false;
  solid_.facetsIn(cell, [&](const Facet& facet) {
    if (facet.normal != Vec3<T>{}) {
      spread_.add(facet.normal);
      own_.add(facet);
    }
    applies = appliesTo(facet, level) ||
              (rules_.curvature && level < rules_.curvature->level && spread_.bound() > mostTurn_);
    return !applies;
  });
  return applies;
}

template <std::floating_point T>
bool FacetRules<T>::appliesTo(const Facet& facet, int level) const {
  for (const auto& rule : rules_.patches) {
    if (rule.patch == facet.owner.patch && level < rule.level) return true;
  }
  if (!rules_.edges || level >= rules_.edges->level) return false;
  const auto bends = [this](const Vec3<T>& a, const Vec3<T>& b) {
    return a != Vec3<T>{} && b != Vec3<T>{} && dot(a, b) < sharpest_;
  };
  const auto& [first, second, third] = facet.across;
  // A facet without area has no normal, and is itself an edge between its neighbours.
  if (facet.normal == Vec3<T>{}) {
    return bends(first, second) || bends(second, third) || bends(third, first);
  }
  return bends(facet.normal, first) || bends(facet.normal, second) || bends(facet.normal, third);
}

template <std::floating_point T>
T FacetRules<T>::reachOf(int level) const {
  T reach = -1;
  for (const auto& rule : {rules_.gaps, rules_.walls}) {
    if (rule && level < rule->level) reach = std::max(reach, rule->cells);
  }
  return reach;
}

template <std::floating_point T>
void FacetRules<T>::lookAround(T reach, std::span<const Box<T>> cells,
                               std::span<const CellTag> tags) {
  const T width = maxComponent(cells[0].size());
  const auto regionOf = [&](const Box<T>& cell) { return cell.grown((reach + kMargin) * width); };
  const auto first = regionOf(cells[0]);
  if (surroundings_.covers(first)) return;
  surroundings_ = first;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (!isOpen(tags[i])) continue;
    auto larger = surroundings_;
    larger.extend(regionOf(cells[i]));
    if (maxComponent(larger.size()) > (2 * (reach + kMargin) + kTogether) * width) break;
    surroundings_ = larger;
  }
  // Facets that facetsIn() adds to a cell's region by round-off are in this one, too.
  around_.clear();
  isAllAround_ = solid_.facetsIn(surroundings_.grown(kMargin * width), [&](const Facet& facet) {
    if (facet.normal != Vec3<T>{}) around_.add(facet);
    return true;
  });
  around_.build();
}

template <std::floating_point T>
bool FacetRules<T>::isNarrow(const Width& rule, Facing facing, int level, const Box<T>& cell) {
  if (!rule || level >= rule->level) return false;
  const T width = maxComponent(cell.size());
  const T least = T(0x1p-20) * width;
  const auto region = cell.grown(rule->cells * width);
  if (!isAllAround_) return seesFacing(region, facing, least);  // samples depend on the box
  const auto outer = region.grown(kMargin * width);
  const auto inner = region.grown(-kMargin * width);
  bool isClose = false;
  const bool isCertain = own_.isFaced(
      around_, facing, least, [&](const Box<T>& box) { return box.overlaps(outer); },
      [&](const Facet& facet) {
        isClose = true;
        return std::ranges::any_of(facet.corners, [&](const auto& p) { return inner.contains(p); });
      });
  return isCertain || (isClose && seesFacing(region, facing, least));
}

template <std::floating_point T>
bool FacetRules<T>::seesFacing(const Box<T>& region, Facing facing, T least) {
  bool isFound = false;
  solid_.facetsIn(region, [&](const Facet& facet) {
    if (facet.normal == Vec3<T>{}) return true;
    other_.clear();
    other_.add(facet);
    other_.build();
    isFound = own_.isFaced(
        other_, facing, least, [](const Box<T>&) { return true; },
        [](const Facet&) { return true; });
    return !isFound;
  });
  return isFound;
}

template class DirectionSpread<float>;
template class DirectionSpread<double>;
template class FacetRules<float>;
template class FacetRules<double>;

}  // namespace cutwater::detail
