#include <Cutwater/Lattice/Detail/Skeleton.hpp>
#include <Cutwater/Lattice/Thickness.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater {

namespace {

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
Thickness<T>::Thickness(T radius) : byPlace_(radius) {
  require(radius > 0, "Thickness: need 0 < radius < infinity", Named{"radius", radius});
}

template <std::floating_point T>
Thickness<T>::Thickness(GradedValue<T> radius) : byPlace_(std::move(radius)) {
  require(byPlace_.least() > 0, "Thickness: need radii that are positive",
          Named{"least", byPlace_.least()});
}

template <std::floating_point T>
Thickness<T> Thickness<T>::byDistanceToCellCenter(T atCenter, T atCorners) {
  constexpr T kCornerDistance = std::numbers::sqrt3_v<T> / 2;  // in units of the cell
  Thickness result(atCenter);
  (void)Thickness(atCorners);  // throws if invalid
  result.byCell_ = {atCenter, (atCorners - atCenter) / kCornerDistance,
                    std::min(atCenter, atCorners), std::max(atCenter, atCorners)};
  return result;
}

template <std::floating_point T>
T Thickness<T>::least() const {
  return byCell_ ? byCell_->least : byPlace_.least();
}
template <std::floating_point T>
T Thickness<T>::most() const {
  return byCell_ ? byCell_->most : byPlace_.most();
}

template <std::floating_point T>
T Thickness<T>::at(const Vec3<T>& point, const Vec3<T>& inCells) const {
  if (!byCell_) return byPlace_.at(point);
  const T radius = byCell_->start + byCell_->slope * length(fromCellCenter(inCells));
  // In this order, NaN gives the least radius.
  return std::min(byCell_->most, std::max(byCell_->least, radius));
}

template <std::floating_point T>
Vec3<T> Thickness<T>::gradient(const Vec3<T>& point, const Vec3<T>& cellSize) const {
  if (!byCell_) return byPlace_.gradient(point);
  const auto inCells = detail::quotient(point, cellSize);
  const T radius = at(point, inCells);
  if (radius == byCell_->least || radius == byCell_->most) return {};
  return byCell_->slope * detail::quotient(normalized(fromCellCenter(inCells)), cellSize);
}

template <std::floating_point T>
Guarantee<T> Thickness<T>::guarantee(T cellSize) const {
  if (!byCell_) return byPlace_.guarantee();
  // A coordinate in cells has an error of two roundings of itself, along each axis.
  constexpr T kUlps = 4;
  const T constant = std::abs(byCell_->slope) / cellSize;
  return {
      .lipschitz = constant, .continuous = true, .ulps = kUlps * (1 + constant), .size = most()};
}

template class Thickness<float>;
template class Thickness<double>;

}  // namespace cutwater
