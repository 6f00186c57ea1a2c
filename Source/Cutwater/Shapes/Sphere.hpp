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
  [[nodiscard]] std::string localName() const override { return "Sphere"; }
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override;
  [[nodiscard]] Box<T> localBoundingBox() const override;

  Vec3<T> center_;
  T radius_;
};

extern template class Sphere<float>;
extern template class Sphere<double>;

}  // namespace cutwater
