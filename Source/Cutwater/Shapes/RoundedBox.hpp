#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// An axis-aligned box whose edges and corners are rounded to a radius; the faces stay in place.
///
///     f(p) = box(p; lower + radius, upper - radius) - radius        exact
///
/// @throws Error unless the corners are finite with lower < upper in every coordinate and
/// 0 < radius <= half the shortest side.
template <std::floating_point T>
class RoundedBox final : public SignedDistanceFunction<T> {
 public:
  RoundedBox(const Box<T>& box, T radius);
  RoundedBox(const Vec3<T>& lower, const Vec3<T>& upper, T radius)
      : RoundedBox(Box<T>{lower, upper}, radius) {}

 private:
  std::string localName() const override { return "Rounded box"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  Box<T> core_;  // the box that is grown by the radius; may have zero thickness
  T radius_;
};

extern template class RoundedBox<float>;
extern template class RoundedBox<double>;

}  // namespace cutwater
