#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// The half-space behind a plane.
///
///     f(p) = (p - point) . normal        exact
///
/// The normal points out of the solid and need not have unit length.
/// @throws Error unless both are finite and the normal is not zero.
template <std::floating_point T>
class Plane final : public SignedDistanceFunction<T> {
 public:
  Plane(const Vec3<T>& point, const Vec3<T>& normal);

 private:
  std::string localName() const override { return "Plane"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  Vec3<T> point_;
  Vec3<T> normal_;
};

extern template class Plane<float>;
extern template class Plane<double>;

}  // namespace cutwater
