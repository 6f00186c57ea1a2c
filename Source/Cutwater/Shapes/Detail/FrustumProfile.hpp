#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater::detail {

/// Exact signed distance in the half-plane of a frustum with flat ends: radius `radiusA` at axial
/// position 0, `radiusB` at `length`.
///
/// The section is convex. Inside, the nearest of its three sides decides. Outside, the nearest
/// point is on the flank if the foot of the perpendicular is, and otherwise on one of the end
/// discs, whose rims are also the ends of the flank.
template <std::floating_point T>
class FrustumProfile {
 public:
  /// The profile of the frustum from a to b.
  FrustumProfile(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;

  /// The box around the body of revolution, as computed.
  [[nodiscard]] Box<T> box(const RotationAxis<T>& axis) const;
  [[nodiscard]] T largestRadius() const { return radiusA_ < radiusB_ ? radiusB_ : radiusA_; }

  // Dimensions and sides, for shapes composed of them.
  [[nodiscard]] T height() const { return length_; }
  [[nodiscard]] T radiusA() const { return radiusA_; }
  [[nodiscard]] T radiusB() const { return radiusB_; }
  /// Signed distance to the line that the flank lies in, and its gradient.
  [[nodiscard]] T flankDistance(const ProfilePoint<T>& p) const;
  [[nodiscard]] const ProfilePoint<T>& flankNormal() const { return normal_; }
  [[nodiscard]] bool hasFootOnFlank(const ProfilePoint<T>& p) const;
  /// The vector to p from the nearest point of the end disc at 0, or at `length`.
  [[nodiscard]] ProfilePoint<T> fromDiscA(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> fromDiscB(const ProfilePoint<T>& p) const;

 private:
  T length_;
  T radiusA_;
  T radiusB_;
  T slant_;                 // length of the flank
  ProfilePoint<T> along_;   // unit vector along the flank, away from a
  ProfilePoint<T> normal_;  // unit vector out of the flank
};

extern template class FrustumProfile<float>;
extern template class FrustumProfile<double>;

}  // namespace cutwater::detail
