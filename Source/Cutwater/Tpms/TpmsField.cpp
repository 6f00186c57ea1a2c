#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/Detail/Constants.hpp>
#include <Cutwater/Tpms/Detail/LargestRadius.hpp>
#include <Cutwater/Tpms/Detail/LevelDistances.hpp>
#include <Cutwater/Tpms/Detail/NumericalGradient.hpp>
#include <Cutwater/Tpms/TpmsField.hpp>

#include <algorithm>

namespace cutwater {

using detail::kOutward;
using detail::kTwoPi;

namespace {

/// Slopes below this fraction of the greatest are replaced by it, which keeps the rounding of
/// distances within 16 times that of levels.
constexpr double kLeastSlope = 1.0 / 16;

}  // namespace

template <std::floating_point T>
TpmsField<T>::TpmsField(TpmsPattern pattern, TpmsMap<T> map)
    : from_(pattern), to_(pattern), map_(std::move(map)) {
  const auto rates = map_.constantRates();
  if (!rates) return;
  const T most = maxComponent(*rates);
  // Finite, as sizes and their reciprocals are: see CellSizes.
  UniformCells uniform{*rates, *rates / most, 0, 1 / (kTwoPi<T> * most)};
  uniform.lipschitz = std::min(static_cast<T>(from_.lipschitz()),
                               static_cast<T>(from_.slopeAlongAxis()) * length(uniform.weight)) *
                      kOutward<T>;
  uniform_ = uniform;
}

template <std::floating_point T>
TpmsField<T>::TpmsField(TpmsTransition<T> transition, TpmsMap<T> map)
    : from_(transition.from),
      to_(transition.to),
      weight_(std::move(transition.weight)),
      map_(std::move(map)) {
  require(weight_->least() >= 0 && weight_->most() <= 1,
          "TpmsField: need weights from 0 to 1 between two patterns",
          Named{"least", weight_->least()}, Named{"most", weight_->most()});
  require(weight_->guarantee().domain == Box<T>::everywhere(),
          "TpmsField: need weights that are known everywhere");
  const auto a = from_.range();
  const auto b = to_.range();
  mostDifference_ = static_cast<T>(std::max(a.upper - b.lower, b.upper - a.lower)) * kOutward<T>;
}

template <std::floating_point T>
T TpmsField<T>::value(const Vec3<T>& p) const {
  const auto cells = map_.toCells(p);
  const T from = from_.value(cells);
  if (!weight_) return from;
  const T weight = weight_->at(p);
  return (1 - weight) * from + weight * to_.value(cells);
}

template <std::floating_point T>
Vec3<T> TpmsField<T>::gradient(const Vec3<T>& p) const {
  if (!uniform_) {
    return detail::numericalGradient([this](const Vec3<T>& q) { return value(q); }, p, map_.size());
  }
  const auto slope = kTwoPi<T> * from_.sample(map_.toCells(p)).gradient;
  const auto& rates = uniform_->rates;
  return {rates.x * slope.x, rates.y * slope.y, rates.z * slope.z};
}

template <std::floating_point T>
T TpmsField<T>::steepness() const {
  return uniform_ ? uniform_->lipschitz / uniform_->lengthPerRadian : Box<T>::kInf;
}

template <std::floating_point T>
T TpmsField<T>::lipschitzWithin(const Vec3<T>& p, T radius) const {
  const auto of = [&](const TpmsPattern& pattern) {
    return map_.lipschitzWithin(p, radius, static_cast<T>(pattern.lipschitz()),
                                static_cast<T>(pattern.slopeAlongAxis()));
  };
  if (!weight_) return of(from_);
  const T change = weight_->lipschitzWithin(p, radius);
  if (change == 0) {
    const T weight = weight_->at(p);
    if (weight == 0 || weight == 1) return of(weight == 0 ? from_ : to_);
  }
  return std::max(of(from_), of(to_)) + change * mostDifference_;
}

template <std::floating_point T>
T TpmsField<T>::freeRadius(T change, const GradedValue<T>& level, const Vec3<T>& p) const {
  return detail::largestRadius<T>(
      [&](T radius) { return lipschitzWithin(p, radius) + level.lipschitzWithin(p, radius); },
      change);
}

template <std::floating_point T>
detail::LevelTerms<T> TpmsField<T>::terms(const detail::PartTerms<T>& part,
                                          const GradedValue<T>& level) const {
  const T levelSlope = level.lipschitz() * uniform_->lengthPerRadian * kOutward<T>;
  return {.part = part,
          .weight = uniform_->weight,
          .levelSlope = levelSlope,
          .leastSlope = static_cast<T>(kLeastSlope) * uniform_->lipschitz,
          .perLipschitz = 1 / (uniform_->lipschitz + levelSlope),
          .twiceCurvature = static_cast<T>(2 * from_.curvature()),
          .lengthPerRadian = uniform_->lengthPerRadian};
}

template <std::floating_point T>
T TpmsField<T>::distance(const detail::PartTerms<T>& part, const GradedValue<T>& level,
                         const Vec3<T>& p) const {
  const T h = level.at(p);
  if (uniform_) {
    return detail::levelDistance(from_.kind(), terms(part, level), map_.toCells(p), h);
  }
  const T field = value(p);
  T psi = part.absolute * std::abs(field) + part.plain * field + part.level * h;
  if (part.half != 0) psi = std::max(psi, part.half * field);
  const T radius = freeRadius(std::abs(psi), level, p);
  return psi < 0 ? -radius : radius;
}

template <std::floating_point T>
void TpmsField<T>::distances(const detail::PartTerms<T>& part, const GradedValue<T>& level,
                             std::span<const Vec3<T>> points, std::span<T> result) const {
  if (!uniform_) {
    for (std::size_t i = 0; i < points.size(); ++i) result[i] = distance(part, level, points[i]);
    return;
  }
  Scratch<detail::LevelBatch<T>, 1> scratch;
  auto& batch = scratch[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto cells = map_.toCells(points[i]);
    batch.inCells[0][i] = cells.x;
    batch.inCells[1][i] = cells.y;
    batch.inCells[2][i] = cells.z;
    batch.level[i] = level.at(points[i]);
  }
  detail::levelDistances(from_.kind(), terms(part, level), batch, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result[i] = batch.distance[i];
}

/// Encloses F in a box, up to the rounding of F.
template <std::floating_point T>
Interval<T> TpmsField<T>::valuesIn(const OrientedBox<T>& box) const {
  const auto sample = from_.sample(map_.toCells(box.center));
  const Vec3<T> angles = kTwoPi<T> * uniform_->rates;  // per length
  const auto& g = sample.gradient;
  const Vec3<T> slope{angles.x * g.x, angles.y * g.y, angles.z * g.z};
  T change = length(slope) * box.slack;
  for (const auto& half : box.halfAxis) change += std::abs(dot(slope, half));
  const T reach = maxComponent(angles) * box.radius();
  change += T(0.5) * static_cast<T>(from_.curvature()) * reach * reach;
  return Interval<T>{sample.value, sample.value}.grown(change * kOutward<T>);
}

template <std::floating_point T>
Interval<T> TpmsField<T>::distancesIn(const detail::PartTerms<T>& part, const GradedValue<T>& level,
                                      const OrientedBox<T>& box) const {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const auto field = valuesIn(box);
  const T radius = box.radius();
  const T h = level.at(box.center);
  const T change = level.lipschitz() * radius * kOutward<T>;
  const Interval<T> size{std::max({T(0), field.lower, -field.upper}),
                         std::max(-field.lower, field.upper)};
  const auto times = [](T factor, const Interval<T>& range) {
    const T a = factor * range.lower;
    const T b = factor * range.upper;
    return Interval<T>{std::min(a, b), std::max(a, b)};
  };
  Interval<T> psi{0, 0};
  for (const auto& term : {times(part.absolute, size), times(part.plain, field),
                           times(part.level, {h - change, h + change})}) {
    psi.lower += term.lower;
    psi.upper += term.upper;
  }
  if (part.half != 0) {
    const auto half = times(part.half, field);
    psi = {std::max(psi.lower, half.lower), std::max(psi.upper, half.upper)};
  }
  // Distances are at least |psi| over the greatest slope. Rounding: that of F and its gradient,
  // which is less than that of distances, at the centre; and that of distances elsewhere.
  const auto bounds = terms(part, level);
  const T perLevel = bounds.perLipschitz * bounds.lengthPerRadian / kOutward<T>;
  const T rounding = 4 * guarantee(level).error(length(box.center) + radius);
  return {psi.lower > 0 ? psi.lower * perLevel - rounding : -kInf,
          psi.upper < 0 ? psi.upper * perLevel + rounding : kInf};
}

template <std::floating_point T>
Guarantee<T> TpmsField<T>::guarantee(const GradedValue<T>& level) const {
  // A level has an error of some 20 eps, and the slope that is used is at least 1/16 of the
  // greatest: 64 eps of a cell exceeds the resulting error. The place has the error of the map. A
  // level's own rounding counts in proportion to the inverse slope of the field, which is at least
  // 1/16 of that in the largest cells.
  Guarantee<T> promise{Quality::LowerBound, Quality::LowerBound, T(1), true};
  const auto ofSlope = [&](const GradedValue<T>& graded, T factor) {
    const T perLevel = factor * 16 * map_.size() / static_cast<T>(kTwoPi<T> * from_.lipschitz());
    promise.ulps += graded.guarantee().ulps * perLevel;
    promise.size = std::max(promise.size, graded.guarantee().size);
  };
  promise.ulps = map_.ulps() + 4;
  promise.size = 8 * map_.size();
  if (!level.isConstant()) ofSlope(level, 1);
  if (weight_ && !weight_->isConstant()) ofSlope(*weight_, mostDifference_);
  return promise;
}

template <std::floating_point T>
double TpmsField<T>::pinch(TpmsChannel channel) const {
  return std::min(from_.pinch(channel), to_.pinch(channel));
}

template <std::floating_point T>
std::string TpmsField<T>::name() const {
  return weight_ ? from_.name() + " to " + to_.name() : from_.name();
}

template class TpmsField<float>;
template class TpmsField<double>;

}  // namespace cutwater
