#pragma once

#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A pyramid over the square |x|, |y| <= side/2 in the plane z = 0, its apex at (0, 0, height).
///
/// Exact. Mirrored so that x >= y >= 0, the point faces the flank across x. Inside, this flank or
/// the base is the nearest; outside, seen in the flank's plane, the flank, one of its edges or,
/// from below, the base.
/// @throws Error unless 0 < side < infinity and 0 < height < infinity.
template <std::floating_point T>
class Pyramid final : public SignedDistanceFunction<T> {
 public:
  Pyramid(T side, T height);

 private:
  [[nodiscard]] std::string localName() const override { return "Pyramid"; }
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override;
  [[nodiscard]] Box<T> localBoundingBox() const override;

  /// x >= y >= 0.
  [[nodiscard]] static Vec3<T> folded(const Vec3<T>& p);
  [[nodiscard]] T flankDistance(const Vec3<T>& q) const;
  /// For a point outside: from the nearest surface point to q.
  [[nodiscard]] Vec3<T> fromSurface(const Vec3<T>& q, T flank) const;

  T half_;  // of the side
  T height_;
  // Unit vectors: in the plane (x, z) out of the flank and up along it; in the flank's plane (y,
  // up), out of the triangle and up along its slanted edge.
  Vec2<T> normal_;
  Vec2<T> up_;
  Vec2<T> edgeNormal_;
  Vec2<T> edgeUp_;
  T edgeLength_;
};

extern template class Pyramid<float>;
extern template class Pyramid<double>;

}  // namespace cutwater
