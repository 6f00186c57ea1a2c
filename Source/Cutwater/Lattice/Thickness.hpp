#pragma once

#include <Cutwater/Operations/Displacement.hpp>

namespace cutwater {

/// Radii that depend on how far something is away: `start` where it is, `end` at `over` and
/// beyond, linear in between. In units of length.
template <std::floating_point T>
struct RadiusRamp {
  T start;
  T end;
  T over;
};

/// What is known of a radius that is a function of position.
template <std::floating_point T>
struct RadiusLimits {
  /// |r(p) - r(q)| <= lipschitz |p - q|, between the limits below.
  T lipschitz;
  /// Where the function is less or more, the radius is that.
  T least;
  T most;
  /// The function's rounding: at most ulps eps (|p| + |r(p)|).
  T ulps = 8;
};

/// The radius of struts, constant or by their place. A value: copies share what it depends on.
///
///     CellArray<double>(cell, cells, 0.4)  // a number is a thickness, too
///     CellArray<double>(cell, cells, Thickness<double>::byDistanceTo(part, {1, 0.4, 10}))
///
/// Places are in the frame of the lattice, and solids and functions given here move along with it.
template <std::floating_point T>
class Thickness {
 public:
  /// The same everywhere. @throws Error unless 0 < radius < infinity.
  Thickness(T radius);  // NOLINT(google-explicit-constructor): where it is constant, it is that
  [[nodiscard]] static Thickness constant(T radius) { return radius; }

  /// By the distance to the surface of a solid, as its values tell it, on both sides alike.
  /// @throws Error unless its radii and length are positive and finite, and the solid has a
  /// Lipschitz constant.
  [[nodiscard]] static Thickness byDistanceTo(Solid<T> solid, const RadiusRamp<T>& ramp);

  /// By the distance to the centre of the cell, in units of the cell, so that it is continuous from
  /// cell to cell, whatever their shape; linear.
  /// @throws Error unless both are positive and finite.
  [[nodiscard]] static Thickness byDistanceToCellCenter(T atCenter, T atCorners);

  /// Any function of position. It is called from several threads at once and must not throw.
  /// @throws Error unless 0 < least <= most < infinity, and the Lipschitz constant is finite and
  /// not negative.
  template <PointFunction<T> Function>
  [[nodiscard]] static Thickness by(Function radius, const RadiusLimits<T>& limits) {
    requireLimits(limits);
    const auto promise = detail::guaranteeOf<T>(functionLimits(limits), limits.most);
    return byField(FunctionSDF<T, Function>(std::move(radius), promise), limits);
  }

  /// The radius at a point, whose coordinates in units of cells are these: whole numbers at the
  /// corners of cells.
  [[nodiscard]] T at(const Vec3<T>& point, const Vec3<T>& inCells) const;
  /// Its gradient there, in an array of cells of this size.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point, const Vec3<T>& cellSize) const;

  /// Whether the radius is the same everywhere, and its range otherwise.
  [[nodiscard]] bool isConstant() const { return measure_ == Measure::None; }
  [[nodiscard]] T least() const { return least_; }
  [[nodiscard]] T most() const { return most_; }
  /// What is known of radii as values of a function: its Lipschitz constant, rounding and domain,
  /// in cells that are nowhere shorter than this.
  [[nodiscard]] Guarantee<T> guarantee(T cellSize) const;

 private:
  /// What the radius depends on.
  enum class Measure : std::uint8_t { None, Surface, Cell, Function };

  Thickness(Measure measure, std::optional<Solid<T>> field, const RadiusRamp<T>& ramp);

  static void requireLimits(const RadiusLimits<T>& limits);
  [[nodiscard]] static FunctionLimits<T> functionLimits(const RadiusLimits<T>& limits) {
    return {.lipschitz = limits.lipschitz, .amplitude = limits.most, .ulps = limits.ulps};
  }
  [[nodiscard]] static Thickness byField(Solid<T> field, const RadiusLimits<T>& limits);
  [[nodiscard]] T measured(const Vec3<T>& point, const Vec3<T>& inCells) const;

  Measure measure_ = Measure::None;
  std::optional<Solid<T>> field_;
  // radius = start + slope * what is measured, within these limits
  T start_;
  T slope_ = 0;
  T least_;
  T most_;
};

extern template class Thickness<float>;
extern template class Thickness<double>;

}  // namespace cutwater
