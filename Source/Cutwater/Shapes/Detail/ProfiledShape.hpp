#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// Base of bodies of revolution whose exact distance in the half-plane is that of a profile: of
/// capsules, cones and cone-spheres, and of beams, which share their profiles.
template <std::floating_point T, typename Profile>
class ProfiledShape : public Axisymmetric<T> {
 protected:
  /// `farthest`: the distance from the origin of the farthest point of the axis that the profile
  /// spans.
  ProfiledShape(const detail::RotationAxis<T>& axis, const Profile& profile, T farthest)
      : Axisymmetric<T>(axis), profile_(profile), size_(farthest + profile.largestRadius()) {}

 private:
  T profileDistance(const ProfilePoint<T>& p) const final;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const final;
  Guarantee<T> localGuarantee() const final;
  std::optional<T> localConcavity(const OrientedBox<T>&) const final { return T(0); }
  Box<T> localBoundingBox() const final;

  Profile profile_;
  T size_;
};

}  // namespace cutwater
