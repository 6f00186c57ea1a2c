#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <limits>

namespace cutwater {

/// Axis-aligned box of closed intervals. A default-constructed box is empty: the identity of
/// extend() for finite points. (It uses the largest number instead of infinity, which code compiled
/// with -ffast-math may assume not to occur.) A box of zero thickness is not empty.
template <std::floating_point T>
struct Box {
  static constexpr T kInf = std::numeric_limits<T>::infinity();  ///< infinity
  static constexpr T kMost = std::numeric_limits<T>::max();      ///< the largest number

  /// The corners with the least and the greatest coordinates.
  Vec3<T> lower{kMost, kMost, kMost};
  Vec3<T> upper{-kMost, -kMost, -kMost};

  /// All of space.
  static constexpr Box everywhere() { return {{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}}; }

  /// Whether the box contains no point: an upper side is below the lower one, or is not a number.
  CUTWATER_INLINE constexpr bool empty() const {
    return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z);
  }
  /// The midpoint; halves before adding, so that it cannot overflow.
  CUTWATER_INLINE constexpr Vec3<T> center() const { return T(0.5) * lower + T(0.5) * upper; }
  CUTWATER_INLINE constexpr Vec3<T> size() const { return upper - lower; }
  CUTWATER_INLINE T diagonal() const { return length(size()); }
  CUTWATER_INLINE constexpr bool contains(const Vec3<T>& p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y && lower.z <= p.z &&
           p.z <= upper.z;
  }
  /// Whether it contains both ends of another box.
  CUTWATER_INLINE constexpr bool covers(const Box& other) const {
    return contains(other.lower) && contains(other.upper);
  }
  /// Corner 0..7: bit 0 chooses upper.x, bit 1 upper.y, bit 2 upper.z.
  CUTWATER_INLINE constexpr Vec3<T> corner(int i) const {
    return {(i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
            (i & 4) != 0 ? upper.z : lower.z};
  }

  /// Grows to contain a point or another box.
  CUTWATER_INLINE constexpr Box& extend(const Vec3<T>& p) {
    lower = min(lower, p);
    upper = max(upper, p);
    return *this;
  }
  CUTWATER_INLINE constexpr Box& extend(const Box& other) {
    lower = min(lower, other.lower);
    upper = max(upper, other.upper);
    return *this;
  }
  /// The box grown by `margin` on every side (shrunk if negative).
  CUTWATER_INLINE constexpr Box grown(T margin) const {
    const Vec3<T> m{margin, margin, margin};
    return {lower - m, upper + m};
  }
  CUTWATER_INLINE constexpr Box intersection(const Box& other) const {
    return {max(lower, other.lower), min(upper, other.upper)};
  }
  /// Whether the boxes have a point in common; touching is enough. An empty box has none.
  CUTWATER_INLINE constexpr bool overlaps(const Box& other) const {
    return !intersection(other).empty();
  }

  bool operator==(const Box&) const = default;
};

/// Whether no coordinate is infinite or NaN.
template <std::floating_point T>
CUTWATER_INLINE inline bool isFinite(const Box<T>& box) {
  return isFinite(box.lower) && isFinite(box.upper);
}

}  // namespace cutwater
