#pragma once

#include <Cutwater/Shapes/Axisymmetric.hpp>

namespace cutwater::detail {

/// Exact signed distance in the half-plane of a frustum with flat ends: radius `radiusA` at axial
/// position 0, `radiusB` at `length`.
///
/// The section is convex. Inside, the nearest of its three sides decides. Outside it is the flank,
/// if the foot of the perpendicular lies on it, or else one of the end discs, whose rims are also
/// the ends of the flank.
template <std::floating_point T>
class FrustumProfile {
 public:
  FrustumProfile(T length, T radiusA, T radiusB);

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;

  [[nodiscard]] T height() const { return length_; }
  [[nodiscard]] T radiusA() const { return radiusA_; }
  [[nodiscard]] T radiusB() const { return radiusB_; }

 private:
  [[nodiscard]] T flankDistance(const ProfilePoint<T>& p) const;
  [[nodiscard]] bool hasFootOnFlank(const ProfilePoint<T>& p) const;
  /// From the nearest point of the end disc at 0, or at `length`, to p.
  [[nodiscard]] ProfilePoint<T> fromDiscA(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> fromDiscB(const ProfilePoint<T>& p) const;

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
