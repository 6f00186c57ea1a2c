#pragma once

#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A piece of a ring about the local z axis with round ends: a tube of radius `minor` around the
/// arc of radius `major` that extends `halfAngle` degrees to both sides of the x axis.
///
///     f(p) = |p - nearest point of the arc| - minor        exact
///
/// If the ends overlap (halfAngle > 90 and major sin(halfAngle) < minor), values inside are lower
/// bounds only.
/// @throws Error unless 0 < minor < major < infinity and 0 < halfAngle <= 180.
template <std::floating_point T>
class CappedTorus final : public SignedDistanceFunction<T> {
 public:
  CappedTorus(T major, T minor, T halfAngle);

 private:
  std::string localName() const override { return "Capped torus"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  std::optional<T> localConcavity(const OrientedBox<T>& box) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  /// Whether the nearest point of the arc is its end; q.y >= 0.
  [[nodiscard]] bool isBeyondEnd(const Vec2<T>& q) const;

  T major_;
  T minor_;
  Vec2<T> toEnd_;  // unit vector to the end of the arc where y >= 0
};

extern template class CappedTorus<float>;
extern template class CappedTorus<double>;

}  // namespace cutwater
