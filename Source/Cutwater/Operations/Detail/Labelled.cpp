#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Labelled.hpp>

#include <algorithm>
#include <functional>

namespace cutwater {

template <std::floating_point T>
Labelled<T>::Labelled(Solid<T> operand, std::string name)
    : UnaryOperation<T>(std::move(operand)), name_(std::move(name)) {
  require(!name_.empty(), "named: need a name that is not empty");
}

template <std::floating_point T>
T Labelled<T>::localSignedDistance(const Vec3<T>& p) const {
  return this->operand().signedDistance(p);
}

template <std::floating_point T>
T Labelled<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return this->operand().signedDistanceWithin(p, wanted);
}

template <std::floating_point T>
void Labelled<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                       std::span<T> distances) const {
  this->operandValues(points, distances);
}

template <std::floating_point T>
Vec3<T> Labelled<T>::localGradient(const Vec3<T>& p) const {
  return this->operand().gradient(p);
}

template <std::floating_point T>
SurfacePoint<T> Labelled<T>::localClosestPoint(const Vec3<T>& p) const {
  return this->operand().closestPoint(p);
}

template <std::floating_point T>
void Labelled<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                     std::span<SurfacePoint<T>> results) const {
  this->operandPoints(points, results);
}

template <std::floating_point T>
SurfaceOwner Labelled<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().owner(p);
}

template <std::floating_point T>
CrossingCount Labelled<T>::localCrossings(const Segment<T>& segment,
                                          CrossingVisitor<T> visit) const {
  return this->operand().crossings(segment, visit);
}

template <std::floating_point T>
Interval<T> Labelled<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  return this->boundsOf(this->operand(), box, hint);
}

template <std::floating_point T>
bool Labelled<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  return this->facetsOf(this->operand(), box, visit);
}

template <std::floating_point T>
BoxClass Labelled<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  return this->classOf(this->operand(), box, hint);
}

template <std::floating_point T>
std::vector<std::string> Labelled<T>::localPatchNames() const {
  auto names = UnaryOperation<T>::localPatchNames();
  const bool areOne = std::ranges::adjacent_find(names, std::not_equal_to()) == names.end();
  for (auto& name : names) name = areOne ? name_ : name_ + "/" + name;
  return names;
}

template class Labelled<float>;
template class Labelled<double>;

}  // namespace cutwater
