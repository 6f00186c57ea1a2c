#pragma once

#include <Cutwater/Core/Detail/Inline.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ostream>
#include <type_traits>

namespace cutwater {

/// Stands for "no face", "no patch" etc. among the library's 32-bit ids.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

template <std::floating_point T>
struct Vec3;

namespace detail {

template <typename V>
using Element = std::remove_cvref_t<decltype(std::declval<const V&>()[0])>;

/// What vector types of applications have in common: floating-point elements behind operator[].
template <typename V>
concept Indexable3 = !std::is_pointer_v<std::decay_t<V>> && requires(const V& v) {
  { v[0] } -> std::convertible_to<Element<V>>;
  requires std::floating_point<Element<V>>;
};

}  // namespace detail

/// A point or direction in 3D: three numbers laid out like `T[3]`, and nothing else.
///
/// Anything that can be indexed and has elements of type T (std::array, Eigen vectors, an
/// application's own types) converts to it. Conversions that lose digits are explicit.
template <std::floating_point T>
struct Vec3 {
  using Scalar = T;

  /// Coordinates; operator[] gives access by number.
  T x{}, y{}, z{};

  CUTWATER_INLINE constexpr Vec3() = default;
  CUTWATER_INLINE constexpr Vec3(T xIn, T yIn, T zIn) : x(xIn), y(yIn), z(zIn) {}
  /// From anything with three elements; explicit where digits would be lost.
  template <detail::Indexable3 V>
  requires(!std::same_as<V, Vec3>) CUTWATER_INLINE  // NOLINTNEXTLINE(google-explicit-constructor)
      constexpr explicit(sizeof(detail::Element<V>) > sizeof(T)) Vec3(const V& v)
      : x(static_cast<T>(v[0])), y(static_cast<T>(v[1])), z(static_cast<T>(v[2])) {}

  CUTWATER_INLINE constexpr T operator[](int axis) const {
    return axis == 0 ? x : axis == 1 ? y : z;
  }
  CUTWATER_INLINE constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const Vec3&) const = default;

  CUTWATER_INLINE friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  CUTWATER_INLINE friend constexpr Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  CUTWATER_INLINE friend constexpr Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  CUTWATER_INLINE friend constexpr Vec3 operator*(T s, Vec3 a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  CUTWATER_INLINE friend constexpr Vec3 operator*(Vec3 a, T s) { return s * a; }
  CUTWATER_INLINE friend constexpr Vec3 operator/(Vec3 a, T s) {
    return {a.x / s, a.y / s, a.z / s};
  }
  /// Component by component.
  CUTWATER_INLINE constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  CUTWATER_INLINE constexpr Vec3& operator-=(Vec3 b) { return *this = *this - b; }
  CUTWATER_INLINE constexpr Vec3& operator*=(T s) { return *this = s * *this; }

  CUTWATER_INLINE friend constexpr T dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  CUTWATER_INLINE friend constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  CUTWATER_INLINE friend constexpr Vec3 min(Vec3 a, Vec3 b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
  }
  CUTWATER_INLINE friend constexpr Vec3 max(Vec3 a, Vec3 b) {
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
  }
  CUTWATER_INLINE friend constexpr Vec3 abs(Vec3 a) {
    return {a.x < 0 ? -a.x : a.x, a.y < 0 ? -a.y : a.y, a.z < 0 ? -a.z : a.z};
  }
  CUTWATER_INLINE friend constexpr T maxComponent(Vec3 a) {
    const T xy = a.x > a.y ? a.x : a.y;
    return xy > a.z ? xy : a.z;
  }
  /// The sum of the absolute values of the components: at least the length.
  CUTWATER_INLINE friend constexpr T oneNorm(Vec3 a) {
    const Vec3 sizes = abs(a);
    return sizes.x + sizes.y + sizes.z;
  }
  CUTWATER_INLINE friend constexpr T lengthSquared(Vec3 a) { return dot(a, a); }
  CUTWATER_INLINE friend T length(Vec3 a) { return std::sqrt(dot(a, a)); }
  /// The unit vector along `a`; zero where `a` is zero.
  CUTWATER_INLINE friend Vec3 normalized(Vec3 a) {
    const T norm = length(a);
    return norm > 0 ? a / norm : Vec3{};
  }
  /// Whether `a` points along an axis, up or down, without the least tilt.
  CUTWATER_INLINE friend constexpr bool isAlong(Vec3 a, int axis) {
    const bool hasPart = a[axis] != 0;
    a[axis] = 0;
    return hasPart && a == Vec3{};
  }
  /// The axis of the component of largest absolute value; the first of equal ones.
  CUTWATER_INLINE friend constexpr int nearestAxis(Vec3 a) {
    const Vec3 sizes = abs(a);
    if (sizes.x >= sizes.y && sizes.x >= sizes.z) return 0;
    return sizes.y >= sizes.z ? 1 : 2;
  }
  CUTWATER_INLINE friend bool isFinite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
  }
  friend std::ostream& operator<<(std::ostream& out, Vec3 a) {
    return out << '(' << a.x << ", " << a.y << ", " << a.z << ')';
  }
};

}  // namespace cutwater
