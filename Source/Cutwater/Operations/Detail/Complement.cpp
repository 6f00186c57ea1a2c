#include <Cutwater/Operations/Detail/Complement.hpp>

namespace cutwater {

template <std::floating_point T>
T Complement<T>::localSignedDistance(const Vec3<T>& p) const {
  return -operand().signedDistance(p);
}

template <std::floating_point T>
T Complement<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return -operand().signedDistanceWithin(p, -wanted);
}

template <std::floating_point T>
void Complement<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                         std::span<T> distances) const {
  this->operandValues(points, distances);
  for (auto& distance : distances) distance = -distance;
}

template <std::floating_point T>
Vec3<T> Complement<T>::localGradient(const Vec3<T>& p) const {
  return -operand().gradient(p);
}

template <std::floating_point T>
SurfacePoint<T> Complement<T>::localClosestPoint(const Vec3<T>& p) const {
  return turned(operand().closestPoint(p));
}

template <std::floating_point T>
void Complement<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                       std::span<SurfacePoint<T>> results) const {
  this->operandPoints(points, results);
  for (auto& result : results) result = turned(result);
}

template <std::floating_point T>
SurfacePoint<T> Complement<T>::turned(SurfacePoint<T> found) {
  found.normal = -found.normal;
  found.distance = -found.distance;
  return found;
}

template <std::floating_point T>
CrossingCount Complement<T>::localCrossings(const Segment<T>& segment,
                                            CrossingVisitor<T> visit) const {
  // A segment end of value 0 is outside both the operand and its complement: the two do not have
  // the same crossings, and only a search by this function's own values finds the right number.
  if (operand().signedDistance(segment.start) == 0 || operand().signedDistance(segment.end) == 0) {
    return SignedDistanceFunction<T>::localCrossings(segment, visit);
  }
  return operand().crossings(segment, [&](Crossing<T> crossing) {
    crossing.normal = -crossing.normal;
    crossing.entering = !crossing.entering;
    return visit(crossing);
  });
}

template <std::floating_point T>
Interval<T> Complement<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  return -this->boundsOf(operand(), box, hint);
}

template <std::floating_point T>
bool Complement<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  return this->facetsOf(operand(), box, [&](SurfaceFacet<T> facet) {
    facet.normal = -facet.normal;
    for (auto& normal : facet.across) normal = -normal;
    return visit(facet);
  });
}

template <std::floating_point T>
BoxClass Complement<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto c = this->classOf(operand(), box, hint);
  if (c == BoxClass::Inside) return BoxClass::Outside;
  return c == BoxClass::Outside ? BoxClass::Inside : c;
}

template <std::floating_point T>
Guarantee<T> Complement<T>::localGuarantee() const {
  auto promise = operand().guarantee();
  std::swap(promise.inside, promise.outside);
  return promise;
}

template class Complement<float>;
template class Complement<double>;

}  // namespace cutwater
