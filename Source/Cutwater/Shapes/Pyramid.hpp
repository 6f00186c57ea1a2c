#pragma once

#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A pyramid over the square |x|, |y| <= side/2 in the plane z = 0, with apex (0, 0, height).
///
/// Exact. The point is mirrored so that x >= y >= 0; it then faces the flank at x > 0. Inside, the
/// nearest point is on this flank or on the base. Outside it is on the flank, on one of its edges
/// or, from below, on the base.
/// @throws Error unless 0 < side < infinity and 0 < height < infinity.
template <std::floating_point T>
class Pyramid final : public SignedDistanceFunction<T> {
 public:
  Pyramid(T side, T height);

 private:
  std::string localName() const override { return "Pyramid"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  /// Mirrored such that x >= y >= 0.
  [[nodiscard]] static Vec3<T> folded(const Vec3<T>& p);
  [[nodiscard]] T flankDistance(const Vec3<T>& q) const;
  /// For a point outside, the vector from the nearest surface point to q.
  [[nodiscard]] Vec3<T> fromSurface(const Vec3<T>& q, T flank) const;

  T half_;  // of the side
  T height_;
  // Unit vectors. In the plane (x, z): out of the flank and up along it. In the flank's plane (y,
  // up): out of the triangle and up along its slanted edge.
  Vec2<T> normal_;
  Vec2<T> up_;
  Vec2<T> edgeNormal_;
  Vec2<T> edgeUp_;
  T edgeLength_;
};

extern template class Pyramid<float>;
extern template class Pyramid<double>;

}  // namespace cutwater
