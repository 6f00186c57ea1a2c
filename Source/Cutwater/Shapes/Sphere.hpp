#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A ball.
///
///     f(p) = |p - center| - radius        exact
///
/// @throws Error unless the centre is finite and 0 < radius < infinity.
template <std::floating_point T>
class Sphere final : public SignedDistanceFunction<T> {
 public:
  Sphere(const Vec3<T>& center, T radius);

 private:
  std::string localName() const override { return "Sphere"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  Vec3<T> center_;
  T radius_;
};

extern template class Sphere<float>;
extern template class Sphere<double>;

}  // namespace cutwater
