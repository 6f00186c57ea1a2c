#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Interval.hpp>

#include <array>
#include <optional>

namespace cutwater {

/// A box of the world in an object's own frame: rotated, with the rounding of the transformation.
///
/// Every transformed point of the world box lies within `slack` of a point center + a halfAxis[0] +
/// b halfAxis[1] + c halfAxis[2] with a, b, c in [-1, 1], and vice versa.
template <std::floating_point T>
struct OrientedBox {
  Vec3<T> center;
  std::array<Vec3<T>, 3> halfAxis;
  T slack = 0;
  /// The very box, where the object's frame has it without any rounding and along its axes. For
  /// shapes that can compare coordinates exactly. Whoever changes the box must reset this.
  std::optional<Box<T>> exact = {};

  /// The box itself, in the frame it is given in. The box must be finite and not empty.
  [[nodiscard]] static OrientedBox of(const Box<T>& box);

  /// A radius about the centre that encloses the box, including slack.
  [[nodiscard]] T radius() const;
  /// A radius about the centre whose ball lies in the box, slack not included.
  [[nodiscard]] T innerRadius() const;
  /// Encloses the distances of the box's points from `p`, including slack and rounding.
  [[nodiscard]] Interval<T> distancesFrom(const Vec3<T>& p) const;
  /// Corner 0..7: bit i chooses +halfAxis[i].
  [[nodiscard]] Vec3<T> corner(int i) const;
  /// The axis-aligned box around this one, including slack.
  [[nodiscard]] Box<T> bounds() const;
  /// Whether the whole box, including slack, lies in the domain.
  [[nodiscard]] bool isWithin(const Box<T>& domain) const;
};

extern template struct OrientedBox<float>;
extern template struct OrientedBox<double>;

}  // namespace cutwater
