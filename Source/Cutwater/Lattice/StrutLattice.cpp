#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/StrutLattice.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

namespace cutwater {

template <std::floating_point T>
StrutLattice<T>::StrutLattice(const char* name, UnitCell cell, const Repeats<T>& cells, T radius)
    : cell_(std::move(cell)), skeleton_(cell_, cells), radius_(radius) {
  const std::string message = std::string(name) + ": need 0 < radius < infinity";
  require(radius > 0 && std::isfinite(radius), message.c_str(), Named{"radius", radius});
  guarantee_ = Guarantee<T>::exact(0);
  guarantee_.inside = Quality::LowerBound;
  // Of an endless lattice, no strut is farther from a point than a few cells.
  const auto box = skeleton_.box();
  guarantee_.size = radius;
  for (int axis = 0; axis < 3; ++axis) {
    const bool isFinite = std::isfinite(box.upper[axis]);
    guarantee_.size += isFinite ? std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]))
                                : 2 * cells.period[axis];
  }
}

template <std::floating_point T>
SkeletonPoint<T> StrutLattice<T>::skeletonPoint(const Vec3<T>& p) const {
  if (!isFinite(p)) return {};
  auto found = skeleton_.nearest(this->transformPoint(p));
  found.away = this->placement().directionToWorld(found.away);
  found.middle = this->placement().toWorld(found.middle);
  return found;
}

template <std::floating_point T>
T StrutLattice<T>::localSignedDistance(const Vec3<T>& p) const {
  return value(skeleton_.distance(p));
}

template <std::floating_point T>
void StrutLattice<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                           std::span<T> distances) const {
  skeleton_.distances(points, distances);
  for (auto& distance : distances) distance = value(distance);
}

template <std::floating_point T>
Vec3<T> StrutLattice<T>::localGradient(const Vec3<T>& p) const {
  return normalized(skeleton_.nearest(p).away);
}

template <std::floating_point T>
SurfacePoint<T> StrutLattice<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto nearest = skeleton_.nearest(p);
  const auto found =
      detail::steppedPoint<T>([this](const Vec3<T>& q) { return localSignedDistance(q); }, p,
                              value(nearest.distance), normalized(nearest.away), guarantee_);
  return found ? *found : SignedDistanceFunction<T>::localClosestPoint(p);
}

template <std::floating_point T>
Box<T> StrutLattice<T>::localBoundingBox() const {
  return guarantee_.grown(skeleton_.box().grown(radius_));
}

template <std::floating_point T>
std::string StrutLattice<T>::localName() const {
  return "Lattice of cells: " + cell_.name();
}

template class StrutLattice<float>;
template class StrutLattice<double>;

}  // namespace cutwater
