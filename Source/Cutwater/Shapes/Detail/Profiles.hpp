#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater::detail {

/// Exact signed distance in the half-plane of a capsule, i.e. of all points within `radius` of the
/// axis from 0 to the length.
///
///     f(p) = |p - nearest point of the segment| - radius
template <std::floating_point T>
class CapsuleProfile {
 public:
  /// The profile of the capsule from a to b.
  /// @throws Error naming the shape `name` unless 0 < radius < infinity.
  CapsuleProfile(const char* name, const Vec3<T>& a, const Vec3<T>& b, T radius);

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;
  /// The box around the body of revolution, as computed.
  [[nodiscard]] Box<T> box(const RotationAxis<T>& axis) const;
  [[nodiscard]] T largestRadius() const { return radius_; }

 private:
  [[nodiscard]] ProfilePoint<T> fromSegment(const ProfilePoint<T>& p) const;

  T length_;
  T radius_;
};

extern template class CapsuleProfile<float>;
extern template class CapsuleProfile<double>;

/// Exact signed distance in the half-plane of a cone-sphere: the hull of a ball at axial position 0
/// and one at the length. See ConeSphere.
template <std::floating_point T>
class ConeSphereProfile {
 public:
  /// The profile of the hull of the balls about a and b.
  /// @throws Error naming the shape `name` unless both radii are finite and not negative, and one
  /// of them is positive.
  ConeSphereProfile(const char* name, const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;
  /// The box around the body of revolution, as computed.
  [[nodiscard]] Box<T> box(const RotationAxis<T>& axis) const;
  [[nodiscard]] T largestRadius() const { return radiusA_ < radiusB_ ? radiusB_ : radiusA_; }
  /// The hull as the distance treats it: where one ball contains the other, that ball alone.
  struct Hull {
    T start, height;      ///< along the axis
    T radius, narrowing;  ///< at the start, and per height
    T cosine;             ///< of the angle between the axis and the flank
  };
  [[nodiscard]] Hull hull() const;

 private:
  enum class Part { BallA, Cone, BallB };
  [[nodiscard]] Part nearestPart(const ProfilePoint<T>& p) const;

  T radiusA_;
  T radiusB_;
  T length_;
  T sine_ = 0;
  T cosine_ = 0;
  bool isBall_;  // one ball contains the other
};

extern template class ConeSphereProfile<float>;
extern template class ConeSphereProfile<double>;

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
