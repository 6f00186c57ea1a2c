#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <bit>
#include <cstdint>

namespace cutwater::detail {

/// An item of the binary build: a box in single precision, in a frame that fits the surrounding
/// items, and the id of its primitive. Only the choice of splits depends on it; node boxes are
/// computed from the primitives' own.
struct alignas(32) SplitItem {
  std::array<float, 3> lower;
  std::uint32_t id;
  std::array<float, 3> upper;
  float unused;  // not initialised, so that allocating an array costs nothing
};

/// Four numbers processed at once; the last is ignored.
using Floats4 = float __attribute__((vector_size(16)));
using Ints4 = std::int32_t __attribute__((vector_size(16)));

inline Floats4 least(Floats4 a, Floats4 b) {
  return a < b ? a : b;
}
inline Floats4 most(Floats4 a, Floats4 b) {
  return a > b ? a : b;
}

/// A growing box, initially empty.
struct Bounds4 {
  static constexpr float kMost = std::numeric_limits<float>::max();
  Floats4 lower{kMost, kMost, kMost, kMost};
  Floats4 upper{-kMost, -kMost, -kMost, -kMost};

  void extend(const Bounds4& other) {
    lower = least(lower, other.lower);
    upper = most(upper, other.upper);
  }
  void extend(Floats4 p) { extend({p, p}); }
};

inline Bounds4 boundsOf(const SplitItem& item) {
  struct Halves {
    Floats4 lower, upper;
  };
  const auto halves = std::bit_cast<Halves>(item);
  constexpr Ints4 kThree{-1, -1, -1, 0};  // the bits of an id may be any float
  return {(Floats4)((Ints4)halves.lower & kThree), halves.upper};
}

/// Twice the centre.
inline Floats4 middle(const Bounds4& box) {
  return box.lower + box.upper;
}

/// Cost of a subtree over `count` items: half its area times the number of leaves.
inline float splitCost(const Bounds4& box, std::size_t count, std::size_t leafWidth) {
  const Floats4 size = box.upper - box.lower;
  const float halfArea = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  const std::size_t leaves = (count + leafWidth - 1) / leafWidth;
  return halfArea * static_cast<float>(leaves);
}

}  // namespace cutwater::detail
