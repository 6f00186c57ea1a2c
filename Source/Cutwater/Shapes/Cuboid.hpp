#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// An axis-aligned box; rotate() turns it.
///
///     d_i = max(lower_i - p_i, p_i - upper_i)
///     f(p) = |max(d, 0)| + min(max_i d_i, 0)        exact
///
/// @throws Error unless the corners are finite and lower < upper in every coordinate.
template <std::floating_point T>
class Cuboid final : public SignedDistanceFunction<T> {
 public:
  explicit Cuboid(const Box<T>& box);
  Cuboid(const Vec3<T>& lower, const Vec3<T>& upper) : Cuboid(Box<T>{lower, upper}) {}

 private:
  std::string localName() const override { return "Box"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  Box<T> box_;
};

extern template class Cuboid<float>;
extern template class Cuboid<double>;

}  // namespace cutwater
