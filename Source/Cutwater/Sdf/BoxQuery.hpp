#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

namespace cutwater {

/// Where a closed box lies. The surface is the boundary of {value < 0}.
enum class BoxClass : std::uint8_t {
  Inside,   ///< certainly no surface in the box, and it is solid
  Outside,  ///< certainly no surface in the box, and it is free
  Cut,      ///< certainly some surface in the box
  Unknown,  ///< neither proven: refine, or treat as Cut
};

/// What a box query has learned about a box, for queries about boxes within it. Start with a
/// default-constructed one. Holds indices only: it can be copied as bytes, and is valid on every
/// process that has the same geometry. Answers are the same with and without it.
struct BoxHint {
  std::array<std::uint32_t, 16> words{};
};
static_assert(std::is_trivially_copyable_v<BoxHint> && sizeof(BoxHint) <= 64);

/// A world box as seen from a shape's own frame: a rotated box, and the rounding made on the way.
///
/// Every point of the world box lies, once transformed, within `slack` of a point
/// center + a halfAxis[0] + b halfAxis[1] + c halfAxis[2] with a, b, c in [-1, 1]; and the other
/// way round.
template <std::floating_point T>
struct OrientedBox {
  Vec3<T> center;
  std::array<Vec3<T>, 3> halfAxis;
  T slack = 0;

  /// The box itself, in the frame it is given in. It must be finite and not empty.
  [[nodiscard]] static OrientedBox of(const Box<T>& box);

  /// No point of the box is farther from the centre.
  [[nodiscard]] T radius() const;
  /// The ball of this radius about the centre lies in the box, slack not included.
  [[nodiscard]] T innerRadius() const;
  /// Corner 0..7: bit i chooses +halfAxis[i].
  [[nodiscard]] Vec3<T> corner(int i) const;
  /// The axis-aligned box around it, slack included.
  [[nodiscard]] Box<T> bounds() const;
  /// Whether all of it lies in the domain, slack included.
  [[nodiscard]] bool isWithin(const Box<T>& domain) const;
};

extern template struct OrientedBox<float>;
extern template struct OrientedBox<double>;

}  // namespace cutwater
