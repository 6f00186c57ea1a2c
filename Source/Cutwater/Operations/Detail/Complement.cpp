#include <Cutwater/Operations/Detail/Complement.hpp>

namespace cutwater {

template <std::floating_point T>
BoxClass Complement<T>::kind(BoxClass ofOperand) const {
  if (ofOperand == BoxClass::Inside) return BoxClass::Outside;
  return ofOperand == BoxClass::Outside ? BoxClass::Inside : ofOperand;
}

template <std::floating_point T>
CrossingCount Complement<T>::localCrossings(const Segment<T>& segment,
                                            CrossingVisitor<T> visit) const {
  // A segment end of value 0 is outside both the operand and its complement: the two do not have
  // the same crossings, and only a search by this function's own values finds the right number.
  if (operand().signedDistance(segment.start) == 0 || operand().signedDistance(segment.end) == 0) {
    return SignedDistanceFunction<T>::localCrossings(segment, visit);
  }
  return Forwarding<T, Complement<T>>::localCrossings(segment, visit);
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
Guarantee<T> Complement<T>::localGuarantee() const {
  auto promise = operand().guarantee();
  std::swap(promise.inside, promise.outside);
  return promise;
}

template class Complement<float>;
template class Complement<double>;

}  // namespace cutwater
