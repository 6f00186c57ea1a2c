#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <optional>

namespace cutwater {

/// What the magnitude of a value means, from the weakest to the strongest.
enum class Quality : std::uint8_t {
  SignOnly,    ///< only the sign is right
  LowerBound,  ///< |value| <= distance to the surface, up to rounding
  Exact,       ///< |value| = distance to the surface, up to rounding
};

/// What a signed distance function promises about its values.
///
/// The sign is always right up to rounding: negative exactly inside the solid. A computed value
/// differs from the exact value of the function by at most error(point).
template <std::floating_point T>
struct Guarantee {
  Quality outside = Quality::SignOnly;
  Quality inside = Quality::SignOnly;
  /// |f(p) - f(q)| <= lipschitz |p - q|, where a constant is known.
  std::optional<T> lipschitz;
  bool continuous = false;
  /// Where all of this holds.
  Box<T> domain = Box<T>::everywhere();
  /// Rounding: see error(). `size` is the largest coordinate or radius in the definition.
  T ulps = 8;
  T size = 0;

  /// The function is the exact signed distance.
  static constexpr Guarantee exact(T size) {
    return {Quality::Exact, Quality::Exact, T(1), true, Box<T>::everywhere(), 8, size};
  }

  /// Bound on the rounding of a value computed at a point of this length: ulps eps (|p| + size).
  [[nodiscard]] constexpr T error(T pointLength) const {
    return ulps * std::numeric_limits<T>::epsilon() * (pointLength + size);
  }
  /// Grows a computed bounding box of the solid so that it encloses the solid despite rounding.
  [[nodiscard]] constexpr Box<T> grown(const Box<T>& box) const {
    if (box.empty()) return box;
    T reach = 0;  // of the farthest corner; infinite sides stay where they are
    for (int axis = 0; axis < 3; ++axis) {
      T farthest = 0;
      for (const T side : {box.lower[axis], box.upper[axis]}) {
        const T distance = side < 0 ? -side : side;
        if (farthest < distance && distance < Box<T>::kInf) farthest = distance;
      }
      reach += farthest;
    }
    return box.grown(error(reach));
  }
  /// Quality on the side where values have this sign; 0 counts as outside.
  [[nodiscard]] constexpr Quality quality(T value) const { return value < 0 ? inside : outside; }

  bool operator==(const Guarantee&) const = default;
};

}  // namespace cutwater
