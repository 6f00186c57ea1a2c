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

/// What all bodies of revolution share: a subclass states the signed distance in the half-plane
/// radial >= 0 beside its axis, and this class turns it around an axis anywhere in space.
///
/// The revolved value is the exact distance wherever the profile's is, because the nearest point of
/// a body of revolution lies in the half-plane of the query point.
template <std::floating_point T>
class Axisymmetric : public SignedDistanceFunction<T> {
 protected:
  /// Axial positions count from `origin` along `axis`, which need not have unit length.
  /// @throws Error, as from the shape `name`, unless both are finite and the axis is not zero.
  Axisymmetric(const char* name, const Vec3<T>& origin, const Vec3<T>& axis);

  [[nodiscard]] virtual T profileDistance(const ProfilePoint<T>& p) const = 0;
  /// Unit gradient in the half-plane; zero where it is not defined.
  [[nodiscard]] virtual ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const = 0;

  [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
  /// Unit vector along the axis.
  [[nodiscard]] const Vec3<T>& axis() const { return axis_; }
  /// Encloses the disc of this radius across the axis around its point at `axial`.
  [[nodiscard]] Box<T> discBox(T axial, T radius) const;
  /// Encloses the ball around the axis' point at `axial`.
  [[nodiscard]] Box<T> ballBox(T axial, T radius) const;

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const final;

  /// Splits p - origin into its part along the axis and the rest.
  struct Split {
    T axial;
    Vec3<T> radial;
  };
  [[nodiscard]] Split split(const Vec3<T>& p) const;

  Vec3<T> origin_;
  Vec3<T> axis_;
};

extern template class Axisymmetric<float>;
extern template class Axisymmetric<double>;

}  // namespace cutwater
