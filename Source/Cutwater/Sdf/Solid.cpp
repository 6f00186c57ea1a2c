#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

template <std::floating_point T>
Solid<T>::Solid(std::unique_ptr<SignedDistanceFunction<T>> shape) {
  require(shape != nullptr, "Solid: need a shape");
  this->setPlacement(shape->placement());
  shape->setPlacement({});
  guarantee_ = shape->guarantee();
  boundingBox_ = shape->boundingBox();
  root_ = std::move(shape);
}

template <std::floating_point T>
T Solid<T>::signedDistanceWithin(const Vec3<T>& point, const Interval<T>& wanted) const {
  if (!isFinite(point)) return std::numeric_limits<T>::quiet_NaN();
  return root_->localSignedDistanceWithin(this->placement().toLocal(point), wanted) + T(0);
}

template <std::floating_point T>
T Solid<T>::localSignedDistance(const Vec3<T>& p) const {
  return root_->localSignedDistance(p);
}

template <std::floating_point T>
T Solid<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return root_->localSignedDistanceWithin(p, wanted);
}

template <std::floating_point T>
void Solid<T>::localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const {
  root_->localSignedDistances(points, distances);
}

template <std::floating_point T>
bool Solid<T>::localSignedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                          std::span<T> distances) const {
  return root_->localSignedDistancesWithin(points, limit, distances);
}

template <std::floating_point T>
Vec3<T> Solid<T>::localGradient(const Vec3<T>& p) const {
  return root_->localGradient(p);
}

template <std::floating_point T>
SurfacePoint<T> Solid<T>::localClosestPoint(const Vec3<T>& p) const {
  return root_->localClosestPoint(p);
}

template <std::floating_point T>
void Solid<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                  std::span<SurfacePoint<T>> results) const {
  root_->localClosestPoints(points, results);
}

template <std::floating_point T>
SurfaceOwner Solid<T>::localOwner(const Vec3<T>& p) const {
  return root_->localOwner(p);
}

template <std::floating_point T>
CrossingCount Solid<T>::localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const {
  return root_->localCrossings(segment, visit);
}

template <std::floating_point T>
void Solid<T>::localCrossingsOfEach(std::span<const Segment<T>> segments,
                                    std::span<CrossingCount> counts,
                                    CrossingsVisitor<T> visit) const {
  root_->localCrossingsOfEach(segments, counts, visit);
}

template <std::floating_point T>
void Solid<T>::localFirstHits(std::span<const Segment<T>> segments,
                              std::span<FirstHit<T>> hits) const {
  root_->localFirstHits(segments, hits);
}

template <std::floating_point T>
Interval<T> Solid<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  return root_->localBounds(box, hint);
}

template <std::floating_point T>
bool Solid<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  return root_->localFacetsIn(box, visit);
}

template <std::floating_point T>
bool Solid<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  return root_->localSurfacesIn(box, visit);
}

template <std::floating_point T>
void Solid<T>::surfacesIn(const Box<T>& box, SurfaceVisitor<T> visit) const {
  if (box.empty() || !isFinite(box)) return;
  this->surfacesOf(*this, OrientedBox<T>::of(box), visit);
}

template <std::floating_point T>
BoxClass Solid<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  return root_->localClassify(box, hint);
}

template <std::floating_point T>
Box<T> Solid<T>::localClearanceBox() const {
  return root_->localClearanceBox();
}

template <std::floating_point T>
void Solid<T>::localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                            std::span<BoxHint> hints) const {
  root_->localClasses(boxes, classes, hints);
}

template <std::floating_point T>
std::vector<std::string> Solid<T>::localPatchNames() const {
  return root_->localPatchNames();
}

template class Solid<float>;
template class Solid<double>;

}  // namespace cutwater
