#include <Cutwater/Lattice/Skeleton.hpp>
#include <Cutwater/Lattice/Thickness.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater {

namespace {

template <std::floating_point T>
bool isPositive(T value) {
  return value > 0 && std::isfinite(value);
}

/// From the centre of a cell to its corners, in units of the cell.
template <std::floating_point T>
constexpr T kCornerDistance = std::numbers::sqrt3_v<T> / 2;

template <std::floating_point T>
Vec3<T> fromCellCenter(const Vec3<T>& inCells) {
  Vec3<T> result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = inCells[axis] - std::floor(inCells[axis]) - T(0.5);
  }
  return result;
}

}  // namespace

template <std::floating_point T>
Thickness<T>::Thickness(T radius) : start_(radius), least_(radius), most_(radius) {
  require(isPositive(radius), "Thickness: need 0 < radius < infinity", Named{"radius", radius});
}

template <std::floating_point T>
Thickness<T>::Thickness(Measure measure, std::optional<Solid<T>> field, const RadiusRamp<T>& ramp)
    : measure_(measure),
      field_(std::move(field)),
      start_(ramp.start),
      slope_((ramp.end - ramp.start) / ramp.over),
      least_(std::min(ramp.start, ramp.end)),
      most_(std::max(ramp.start, ramp.end)) {
  require(isPositive(ramp.start) && isPositive(ramp.end),
          "Thickness: need radii that are positive and finite", Named{"start", ramp.start},
          Named{"end", ramp.end});
  require(isPositive(ramp.over) && std::isfinite(slope_),
          "Thickness: need a length that is positive and finite to go from one radius to the other",
          Named{"over", ramp.over});
}

template <std::floating_point T>
Thickness<T> Thickness<T>::byDistanceTo(Solid<T> solid, const RadiusRamp<T>& ramp) {
  const auto promise = solid.guarantee();
  require(promise.continuous && promise.lipschitz && std::isfinite(*promise.lipschitz),
          "Thickness: need a solid whose values have a Lipschitz constant");
  return {Measure::Surface, std::move(solid), ramp};
}

template <std::floating_point T>
Thickness<T> Thickness<T>::byDistanceToCellCenter(T atCenter, T atCorners) {
  return {Measure::Cell, std::nullopt, {atCenter, atCorners, kCornerDistance<T>}};
}

template <std::floating_point T>
void Thickness<T>::requireLimits(const RadiusLimits<T>& limits) {
  require(limits.least > 0 && limits.least <= limits.most && std::isfinite(limits.most),
          "Thickness: need 0 < least <= most < infinity", Named{"least", limits.least},
          Named{"most", limits.most});
  detail::requireLimits("Thickness", functionLimits(limits));
}

template <std::floating_point T>
Thickness<T> Thickness<T>::byField(Solid<T> field, const RadiusLimits<T>& limits) {
  Thickness result(limits.most);
  result.measure_ = Measure::Function;
  result.field_ = std::move(field);
  result.start_ = 0;
  result.slope_ = 1;
  result.least_ = limits.least;
  return result;
}

template <std::floating_point T>
T Thickness<T>::measured(const Vec3<T>& point, const Vec3<T>& inCells) const {
  if (measure_ == Measure::Function) return field_->signedDistance(point);
  if (measure_ == Measure::Surface) return std::abs(field_->signedDistance(point));
  return length(fromCellCenter(inCells));
}

template <std::floating_point T>
T Thickness<T>::at(const Vec3<T>& point, const Vec3<T>& inCells) const {
  if (isConstant()) return start_;
  // In this order, what is not a number gives the least radius.
  return std::min(most_, std::max(least_, start_ + slope_ * measured(point, inCells)));
}

template <std::floating_point T>
Vec3<T> Thickness<T>::gradient(const Vec3<T>& point, const Vec3<T>& cellSize) const {
  const auto inCells = detail::quotient(point, cellSize);
  const T radius = at(point, inCells);
  if (isConstant() || radius == least_ || radius == most_) return {};
  if (measure_ == Measure::Cell) {
    return slope_ * detail::quotient(normalized(fromCellCenter(inCells)), cellSize);
  }
  const bool isInside = measure_ == Measure::Surface && field_->signedDistance(point) < 0;
  return (isInside ? -slope_ : slope_) * field_->gradient(point);
}

template <std::floating_point T>
Guarantee<T> Thickness<T>::guarantee(T cellSize) const {
  constexpr T kUlps = 4;  // of the sum above
  if (isConstant()) return {.lipschitz = T(0), .continuous = true, .ulps = 0, .size = most_};
  const T slope = std::abs(slope_);
  if (measure_ == Measure::Cell) {
    // A coordinate in cells is off by two roundings of itself, along each axis.
    const T constant = slope / cellSize;
    return {
        .lipschitz = constant, .continuous = true, .ulps = kUlps * (1 + constant), .size = most_};
  }
  auto known = field_->guarantee();
  known.outside = known.inside = Quality::SignOnly;
  known.lipschitz = slope * *known.lipschitz;
  known.ulps = slope * known.ulps + kUlps;
  known.size = std::max(known.size, most_);
  return known;
}

template class Thickness<float>;
template class Thickness<double>;

}  // namespace cutwater
