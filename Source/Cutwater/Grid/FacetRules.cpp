#include <Cutwater/Grid/FacetRules.hpp>

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
  // The direction farthest from all axes lies between (1, 0, 0), (1, 1, 0) and (1, 1, 1), at
  // (1, sqrt(2) - 1, sqrt(3) - sqrt(2)): 0.8864 of its length is along each.
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
bool FacetRules<T>::matter(int level) const {
  const auto applies = [level](const auto& rule) { return rule && level < rule->level; };
  return std::ranges::any_of(rules_.patches, [level](const auto& r) { return level < r.level; }) ||
         applies(rules_.curvature) || applies(rules_.edges) || applies(rules_.gaps) ||
         applies(rules_.walls);
}

template <std::floating_point T>
bool FacetRules<T>::ask(int level, const Box<T>& cell) {
  facets_.clear();
  DirectionSpread<T> spread;
  bool isAsked = false;
  solid_.facetsIn(cell, [&](const Facet& facet) {
    if (facet.normal != Vec3<T>{}) {
      spread.add(facet.normal);
      facets_.push_back(facet);
    }
    isAsked = askOf(facet, level) ||
              (rules_.curvature && level < rules_.curvature->level && spread.bound() > mostTurn_);
    return !isAsked;
  });
  return isAsked || isNarrow(level, cell);
}

template <std::floating_point T>
bool FacetRules<T>::askOf(const Facet& facet, int level) const {
  for (const auto& rule : rules_.patches) {
    if (rule.patch == facet.owner.patch && level < rule.level) return true;
  }
  if (!rules_.edges || level >= rules_.edges->level) return false;
  return std::ranges::any_of(facet.across, [&](const Vec3<T>& normal) {
    return normal != Vec3<T>{} && dot(normal, facet.normal) < sharpest_;
  });
}

template <std::floating_point T>
bool FacetRules<T>::isNarrow(int level, const Box<T>& cell) const {
  const T width = maxComponent(cell.size());
  const auto hasFacing = [&](const std::optional<typename Refinement<T>::Width>& rule, T side) {
    if (!rule || level >= rule->level || facets_.empty()) return false;
    bool isFound = false;
    solid_.facetsIn(cell.grown(rule->cells * width), [&](const Facet& other) {
      isFound = std::ranges::any_of(
          facets_, [&](const Facet& own) { return face(own, other, side, T(0x1p-20) * width); });
      return !isFound;
    });
    return isFound;
  };
  return hasFacing(rules_.gaps, 1) || hasFacing(rules_.walls, -1);
}

/// Whether they face each other within 60 degrees: with their fronts if side is 1, their backs if
/// it is -1; at least so far apart somewhere.
template <std::floating_point T>
bool FacetRules<T>::face(const Facet& a, const Facet& b, T side, T least) {
  if (!(dot(a.normal, b.normal) < T(-0.5))) return false;
  const auto isBefore = [&](const Facet& from, const Facet& of) {
    return std::ranges::any_of(from.corners, [&](const Vec3<T>& corner) {
      return side * dot(of.normal, corner - of.corners[0]) > least;
    });
  };
  return isBefore(a, b) && isBefore(b, a);
}

template class DirectionSpread<float>;
template class DirectionSpread<double>;
template class FacetRules<float>;
template class FacetRules<double>;

}  // namespace cutwater::detail
