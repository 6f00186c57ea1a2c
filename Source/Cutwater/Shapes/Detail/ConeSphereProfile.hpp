#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater::detail {

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

}  // namespace cutwater::detail
