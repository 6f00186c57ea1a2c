#pragma once

#include <Cutwater/Operations/GradedValue.hpp>

namespace cutwater {

/// The radius of struts, constant or dependent on position. A value type: copies share what it
/// depends on.
///
///     PeriodicLattice<double>(cell, cells, 0.4)  // a plain number will do
///     PeriodicLattice<double>(cell, cells, Thickness<double>::byDistanceTo(part, {1, 0.4, 10}))
///
/// Positions are in the frame of the lattice; solids and functions given here move along with it.
template <std::floating_point T>
class Thickness {
 public:
  /// A radius that is the same everywhere. @throws Error unless 0 < radius < infinity.
  Thickness(T radius);  // NOLINT(google-explicit-constructor): conversion is intended
  [[nodiscard]] static Thickness constant(T radius) { return radius; }

  /// Radii that depend on position, in units of length. @throws Error unless 0 < least.
  explicit Thickness(GradedValue<T> radius);
  /// Depends on the distance to the surface of a solid: the magnitude of its value, in the same way
  /// on both sides.
  /// @throws Error unless its radii and length are positive and finite, and the solid has a
  /// Lipschitz constant.
  [[nodiscard]] static Thickness byDistanceTo(Solid<T> solid, const GradedRamp<T>& ramp) {
    return Thickness(GradedValue<T>::byDistanceTo(std::move(solid), ramp));
  }
  /// Any function of position. It is called from several threads at once and must not throw.
  /// @throws Error unless 0 < least <= most < infinity, and the Lipschitz constant is finite and
  /// not negative.
  template <PointFunction<T> Function>
  [[nodiscard]] static Thickness by(Function radius, const GradedLimits<T>& limits) {
    return Thickness(GradedValue<T>::by(std::move(radius), limits));
  }

  /// Depends linearly on the distance to the centre of the cell, in units of the cell, so that it
  /// is continuous from cell to cell, whatever their shape.
  /// @throws Error unless both are positive and finite.
  [[nodiscard]] static Thickness byDistanceToCellCenter(T atCenter, T atCorners);

  /// The radius at a point. `inCells`: its coordinates in units of cells, which are whole numbers
  /// at the corners of cells.
  [[nodiscard]] T at(const Vec3<T>& point, const Vec3<T>& inCells) const;
  /// The gradient of the radius at a point, in an array of cells of this size.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point, const Vec3<T>& cellSize) const;

  /// Whether the radius is the same everywhere, and its range otherwise.
  [[nodiscard]] bool isConstant() const { return !byCell_ && byPlace_.isConstant(); }
  [[nodiscard]] T least() const;
  [[nodiscard]] T most() const;
  /// Guarantee of radii as values of a function: its Lipschitz constant, rounding and domain, in
  /// cells that are nowhere shorter than this.
  [[nodiscard]] Guarantee<T> guarantee(T cellSize) const;

 private:
  GradedValue<T> byPlace_;
  /// Used instead: start + slope * (distance to the centre of the cell), clamped to these limits.
  struct ByCell {
    T start;
    T slope;
    T least;
    T most;
  };
  std::optional<ByCell> byCell_;
};

extern template class Thickness<float>;
extern template class Thickness<double>;

}  // namespace cutwater
