#pragma once

#include <Cutwater/Operations/Detail/Forwarding.hpp>

namespace cutwater {

/// All points that are not in the operand.
///
///     f(p) = -g(p)        outside, what the operand guarantees inside, and vice versa
///
/// Points of value 0 are outside both, as for any solid.
template <std::floating_point T>
class Complement final : public Forwarding<T, Complement<T>> {
 public:
  explicit Complement(Solid<T> solid) : Forwarding<T, Complement<T>>(std::move(solid)) {}

  using UnaryOperation<T>::operand;

 private:
  friend Forwarding<T, Complement<T>>;
  [[nodiscard]] Interval<T> wantedOfOperand(const Interval<T>& wanted) const { return -wanted; }
  [[nodiscard]] T value(T ofOperand) const { return -ofOperand; }
  [[nodiscard]] Interval<T> range(const Interval<T>& ofOperand) const { return -ofOperand; }
  [[nodiscard]] BoxClass kind(BoxClass ofOperand) const;
  void turn(Vec3<T>& direction) const { direction = -direction; }
  void adjust(SurfacePoint<T>& found, const Vec3<T>& /*p*/) const {
    found.normal = -found.normal;
    found.distance = -found.distance;
  }
  void adjust(Crossing<T>& found) const {
    found.normal = -found.normal;
    found.entering = !found.entering;
  }

  std::string localName() const override { return "Complement"; }
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override {
    this->surfacesOf(operand(), box, visit);
    return true;
  }
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override { return Box<T>::everywhere(); }
};

extern template class Complement<float>;
extern template class Complement<double>;

}  // namespace cutwater
