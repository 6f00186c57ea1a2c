#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Interval.hpp>

#include <array>

namespace cutwater {

/// A box of the world as seen from an object's own frame: rotated, and with the rounding made on
/// the way.
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
  /// Encloses the distances of its points from `p`, slack and rounding included.
  [[nodiscard]] Interval<T> distancesFrom(const Vec3<T>& p) const;
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
