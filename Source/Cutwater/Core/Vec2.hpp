#pragma once

#include <Cutwater/Core/Detail/Inline.hpp>

#include <cmath>
#include <concepts>

namespace cutwater {

/// A point or direction in a plane.
template <std::floating_point T>
struct Vec2 {
  T x{}, y{};

  bool operator==(const Vec2&) const = default;

  CUTWATER_INLINE friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  CUTWATER_INLINE friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  CUTWATER_INLINE friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  CUTWATER_INLINE friend constexpr Vec2 operator*(T s, Vec2 a) { return {s * a.x, s * a.y}; }
  CUTWATER_INLINE friend constexpr Vec2 operator/(Vec2 a, T s) { return {a.x / s, a.y / s}; }

  CUTWATER_INLINE friend constexpr T dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
  /// Twice the area of the triangle (0, a, b); positive if b lies to the left of a.
  CUTWATER_INLINE friend constexpr T cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
  CUTWATER_INLINE friend T length(Vec2 a) { return std::sqrt(dot(a, a)); }
  /// The unit vector along `a`; zero where `a` is zero.
  CUTWATER_INLINE friend Vec2 normalized(Vec2 a) {
    const T norm = length(a);
    return norm > 0 ? a / norm : Vec2{};
  }
  CUTWATER_INLINE friend bool isFinite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }
};

}  // namespace cutwater
