#include <Cutwater/Lattice/Detail/CellSkeleton.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
PeriodicLattice<T>::PeriodicLattice(UnitCell cell, const Vec3<T>& size, Thickness<T> thickness)
    : PeriodicLattice(std::move(cell), Repeats<T>{.period = size}, std::move(thickness)) {}

template <std::floating_point T>
PeriodicLattice<T>::PeriodicLattice(UnitCell cell, const Repeats<T>& cells, Thickness<T> thickness)
    : cell_(std::move(cell)),
      cells_(cells),
      skeleton_(std::make_shared<const detail::CellSkeleton<T>>(cell_, cells)),
      thickness_(std::move(thickness)) {
  const auto& period = cells.period;
  const auto radii = thickness_.guarantee(std::min({period.x, period.y, period.z}));
  slope_ = 1 + *radii.lipschitz;
  guarantee_ = Guarantee<T>::exact(0);
  guarantee_.inside = Quality::LowerBound;
  if (!thickness_.isConstant()) guarantee_.outside = Quality::LowerBound;
  guarantee_.domain = radii.domain;
  guarantee_.ulps += radii.ulps;
  // No strut of an endless lattice is farther from a point than a few cells.
  const auto box = skeleton_->box();
  guarantee_.size = radii.size;
  for (int axis = 0; axis < 3; ++axis) {
    const bool isFinite = std::isfinite(box.upper[axis]);
    guarantee_.size += isFinite ? std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]))
                                : 2 * period[axis];
  }
}

template <std::floating_point T>
SkeletonPoint<T> PeriodicLattice<T>::skeletonPoint(const Vec3<T>& p) const {
  if (!isFinite(p)) return {};
  auto found = skeleton_->nearest(this->transformPoint(p));
  found.away = this->placement().directionToWorld(found.away);
  found.middle = this->placement().toWorld(found.middle);
  return found;
}

template <std::floating_point T>
T PeriodicLattice<T>::gradedValue(const Vec3<T>& p, T distance) const {
  return (distance - thickness_.at(p, detail::quotient(p, cells_.period))) / slope_;
}

template <std::floating_point T>
T PeriodicLattice<T>::localSignedDistance(const Vec3<T>& p) const {
  return value(p, skeleton_->distance(p));
}

template <std::floating_point T>
void PeriodicLattice<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                              std::span<T> distances) const {
  skeleton_->distances(points, distances);
  for (std::size_t i = 0; i < points.size(); ++i) distances[i] = value(points[i], distances[i]);
}

template <std::floating_point T>
Vec3<T> PeriodicLattice<T>::localGradient(const Vec3<T>& p) const {
  const auto outward = normalized(skeleton_->nearest(p).away);
  if (thickness_.isConstant()) return outward;
  return (outward - thickness_.gradient(p, cells_.period)) / slope_;
}

template <std::floating_point T>
SurfacePoint<T> PeriodicLattice<T>::localClosestPoint(const Vec3<T>& p) const {
  if (!thickness_.isConstant()) return SignedDistanceFunction<T>::localClosestPoint(p);
  const auto nearest = skeleton_->nearest(p);
  const auto found =
      detail::steppedPoint<T>([this](const Vec3<T>& q) { return localSignedDistance(q); }, p,
                              value(p, nearest.distance), normalized(nearest.away), guarantee_);
  return found ? *found : SignedDistanceFunction<T>::localClosestPoint(p);
}

template <std::floating_point T>
Box<T> PeriodicLattice<T>::localBoundingBox() const {
  return guarantee_.grown(skeleton_->box().grown(thickness_.most()));
}

template <std::floating_point T>
std::string PeriodicLattice<T>::localName() const {
  return (thickness_.isConstant() ? "Lattice of cells: " : "Graded lattice of cells: ") +
         cell_.name();
}

template class PeriodicLattice<float>;
template class PeriodicLattice<double>;

}  // namespace cutwater
