#pragma once

#include <Cutwater/Lattice/PeriodicLattice.hpp>

#include <algorithm>

namespace cutwater::detail {

/// A strut's axis, prepared for computing distances.
template <std::floating_point T>
struct StrutAxis {
  Vec3<T> start;
  Vec3<T> along;  ///< to its end
  T perSquare{};  ///< 1 / |along|^2

  StrutAxis(const Vec3<double>& a, const Vec3<double>& b)
      : start(a), along(b - a), perSquare(static_cast<T>(1 / lengthSquared(b - a))) {}

  /// The vector from the nearest point of the axis to p.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> awayFrom(const Vec3<T>& p) const {
    const Vec3<T> d = p - start;
    const T place = std::min(std::max(dot(d, along) * perSquare, T(0)), T(1));
    return d - place * along;
  }
};

/// Product and quotient, component by component.
template <std::floating_point T>
[[nodiscard]] CUTWATER_INLINE constexpr Vec3<T> times(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <std::floating_point T>
[[nodiscard]] CUTWATER_INLINE constexpr Vec3<T> quotient(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x / b.x, a.y / b.y, a.z / b.z};
}

}  // namespace cutwater::detail
