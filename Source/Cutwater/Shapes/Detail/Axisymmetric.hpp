#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A point in the half-plane of an axisymmetric shape: distance from the axis, position along it.
template <std::floating_point T>
struct ProfilePoint {
  T radial{};
  T axial{};

  CUTWATER_INLINE friend T length(const ProfilePoint& p) {
    return std::sqrt(p.radial * p.radial + p.axial * p.axial);
  }
  /// The unit vector along p; zero where p is zero.
  CUTWATER_INLINE friend ProfilePoint normalized(const ProfilePoint& p) {
    const T norm = length(p);
    return norm > 0 ? ProfilePoint{p.radial / norm, p.axial / norm} : ProfilePoint{};
  }
};

namespace detail {

/// The axis of a body of revolution.
template <std::floating_point T>
class RotationAxis {
 public:
  /// Axial positions are measured from `origin` along `direction`, which need not have unit length.
  /// @throws Error naming the shape `name` unless both are finite and the direction is not zero.
  RotationAxis(const char* name, const Vec3<T>& origin, const Vec3<T>& direction);

  /// The axis from `a` to `b`, or along z if they coincide.
  [[nodiscard]] static RotationAxis between(const char* name, const Vec3<T>& a, const Vec3<T>& b) {
    return {name, a, a == b ? Vec3<T>{0, 0, 1} : b - a};
  }

  [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
  /// A unit vector.
  [[nodiscard]] const Vec3<T>& direction() const { return direction_; }

  /// p - origin, split into its parts along the axis and normal to it.
  struct Split {
    T axial;
    Vec3<T> radial;
  };
  [[nodiscard]] CUTWATER_INLINE Split split(const Vec3<T>& p) const {
    const Vec3<T> d = p - origin_;
    const T axial = dot(d, direction_);
    return {axial, d - axial * direction_};
  }
  [[nodiscard]] CUTWATER_INLINE ProfilePoint<T> profilePoint(const Vec3<T>& p) const {
    const auto [axial, radial] = split(p);
    return {length(radial), axial};
  }
  /// The gradient at p of a function whose gradient in the half-plane is `g`. Zero on the axis
  /// where the function is equally steep in every direction away from it.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> revolved(const Split& p, const ProfilePoint<T>& g) const {
    if (g.radial == 0) return g.axial * direction_;
    const T distance = length(p.radial);
    if (!(distance > 0)) return {};
    return (g.radial / distance) * p.radial + g.axial * direction_;
  }

  /// Encloses the disc of this radius normal to the axis around its point at `axial`.
  [[nodiscard]] Box<T> discBox(T axial, T radius) const;
  /// Encloses the ball around the axis' point at `axial`.
  [[nodiscard]] Box<T> ballBox(T axial, T radius) const;

 private:
  Vec3<T> origin_;
  Vec3<T> direction_;
};

extern template class RotationAxis<float>;
extern template class RotationAxis<double>;

}  // namespace detail

/// Base class of all bodies of revolution: a subclass defines the signed distance in the half-plane
/// radial >= 0 beside its axis, and this class revolves it about an axis anywhere in space.
///
/// The revolved value is the exact distance wherever that of the profile is, because the nearest
/// point of a body of revolution lies in the half-plane of the query point.
template <std::floating_point T>
class Axisymmetric : public SignedDistanceFunction<T> {
 protected:
  /// Axial positions are measured from `origin` along `axis`, which need not have unit length.
  /// @throws Error naming the shape `name` unless both are finite and the axis is not zero.
  Axisymmetric(const char* name, const Vec3<T>& origin, const Vec3<T>& axis)
      : axis_(name, origin, axis) {}
  explicit Axisymmetric(const detail::RotationAxis<T>& axis) : axis_(axis) {}

  /// The signed distance of the profile in the half-plane.
  [[nodiscard]] virtual T profileDistance(const ProfilePoint<T>& p) const = 0;
  /// Unit gradient in the half-plane; zero where it is not defined.
  [[nodiscard]] virtual ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const = 0;

  [[nodiscard]] const Vec3<T>& origin() const { return axis_.origin(); }
  /// Unit vector along the axis.
  [[nodiscard]] const Vec3<T>& axis() const { return axis_.direction(); }
  [[nodiscard]] const detail::RotationAxis<T>& rotationAxis() const { return axis_; }

 private:
  T localSignedDistance(const Vec3<T>& p) const final;
  Vec3<T> localGradient(const Vec3<T>& p) const final;

  detail::RotationAxis<T> axis_;
};

extern template class Axisymmetric<float>;
extern template class Axisymmetric<double>;

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
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const final;
  Guarantee<T> localGuarantee() const final;
  std::optional<T> localConcavity(const OrientedBox<T>&) const final { return T(0); }
  Box<T> localBoundingBox() const final;

  Profile profile_;
  T size_;
};

}  // namespace cutwater
