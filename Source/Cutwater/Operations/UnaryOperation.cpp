#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

template <std::floating_point T>
T UnaryOperation<T>::localSignedDistance(const Vec3<T>& p) const {
  return operand_.signedDistance(p);
}

template <std::floating_point T>
void UnaryOperation<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                             std::span<T> distances) const {
  operand_.signedDistances(points, distances, {.threads = 1});
}

template <std::floating_point T>
Vec3<T> UnaryOperation<T>::localGradient(const Vec3<T>& p) const {
  return operand_.gradient(p);
}

template <std::floating_point T>
SurfacePoint<T> UnaryOperation<T>::localClosestPoint(const Vec3<T>& p) const {
  return operand_.closestPoint(p);
}

template <std::floating_point T>
void UnaryOperation<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                           std::span<SurfacePoint<T>> results) const {
  operand_.closestPoints(points, results, {.threads = 1});
}

template <std::floating_point T>
SurfaceOwner UnaryOperation<T>::localOwner(const Vec3<T>& p) const {
  return operand_.owner(p);
}

template <std::floating_point T>
CrossingCount UnaryOperation<T>::localCrossings(const Segment<T>& segment,
                                                CrossingVisitor<T> visit) const {
  return operand_.crossings(segment, visit);
}

template <std::floating_point T>
Interval<T> UnaryOperation<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  return this->boundsOf(operand_, box);
}

template <std::floating_point T>
BoxClass UnaryOperation<T>::localClassify(const OrientedBox<T>& box, BoxHint*) const {
  return this->classOf(operand_, box);
}

template <std::floating_point T>
std::vector<std::string> UnaryOperation<T>::localPatchNames() const {
  return operand_.patchNames();
}

template class UnaryOperation<float>;
template class UnaryOperation<double>;

}  // namespace cutwater
