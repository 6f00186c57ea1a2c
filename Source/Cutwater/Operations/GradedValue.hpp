#pragma once

#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// A number that depends on the value of a solid, e.g. the distance to a plane: `start` where the
/// value is 0 or less, `end` where it is `over` or more, and linear in between.
template <std::floating_point T>
struct GradedRamp {
  T start;
  T end;
  T over;
};

/// Known properties of a number that is a function of position.
template <std::floating_point T>
struct GradedLimits {
  /// |h(p) - h(q)| <= lipschitz |p - q|, between the limits below.
  T lipschitz;
  /// The function's values are clamped to this range.
  T least;
  T most;
  /// Bound of the function's rounding: ulps eps (|p| + |h(p)|).
  T ulps = 8;
};

/// A number that is constant or depends on position: a radius, a thickness, a level, a weight. A
/// value type: copies share what it depends on.
///
///     TpmsSolid<double>(field, TpmsPart::Wall, 0.3)  // a plain number will do
///     GradedValue<double>::byValueOf(part, {.start = 0.2, .end = 0.6, .over = 10})
///
/// Positions are in the frame of the shape that it is given to, and move along with it.
template <std::floating_point T>
class GradedValue {
 public:
  /// A number that is the same everywhere. @throws Error unless it is finite.
  GradedValue(T value);  // NOLINT(google-explicit-constructor): conversion is intended

  // Out of line: when inlined, g++ 12 takes an empty optional for uninitialised.
  GradedValue(const GradedValue&);
  GradedValue(GradedValue&&) noexcept;
  GradedValue& operator=(const GradedValue&);
  GradedValue& operator=(GradedValue&&) noexcept;
  ~GradedValue();

  /// Depends on the value of a solid, which need not be a distance.
  /// @throws Error unless the ramp is finite and 0 < over, and the solid's values are continuous
  /// with a Lipschitz constant.
  [[nodiscard]] static GradedValue byValueOf(Solid<T> solid, const GradedRamp<T>& ramp);
  /// Depends on the magnitude of that value: the distance to the surface, as the solid's values
  /// give it, on both sides alike. @throws Error as above.
  [[nodiscard]] static GradedValue byDistanceTo(Solid<T> solid, const GradedRamp<T>& ramp);

  /// Any function of position. It is called from several threads at once and must not throw.
  /// @throws Error unless least <= most, all limits are finite, and the Lipschitz constant is not
  /// negative.
  template <PointFunction<T> Function>
  [[nodiscard]] static GradedValue by(Function function, const GradedLimits<T>& limits) {
    requireLimits(limits);
    const auto promise =
        detail::guaranteeOf<T>(functionLimits(limits), std::max(-limits.least, limits.most));
    return byField(FunctionSDF<T, Function>(std::move(function), promise), limits);
  }

  /// The number at a point, its gradient there, and whether it is the same everywhere.
  [[nodiscard]] T at(const Vec3<T>& p) const;
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& p) const;
  [[nodiscard]] bool isConstant() const { return !field_; }
  [[nodiscard]] T least() const { return least_; }
  [[nodiscard]] T most() const { return most_; }
  /// Guarantee of the numbers as values of a function: its Lipschitz constant, rounding and domain.
  [[nodiscard]] const Guarantee<T>& guarantee() const { return known_; }
  [[nodiscard]] T lipschitz() const { return *known_.lipschitz; }
  /// Lipschitz constant within the ball of this radius about p.
  [[nodiscard]] T lipschitzWithin(const Vec3<T>& p, T radius) const;

 private:
  static void requireLimits(const GradedLimits<T>& limits);
  [[nodiscard]] static FunctionLimits<T> functionLimits(const GradedLimits<T>& limits) {
    return {.lipschitz = limits.lipschitz, .ulps = limits.ulps};
  }
  [[nodiscard]] static GradedValue byField(Solid<T> field, const GradedLimits<T>& limits);
  void setField(Solid<T> field);
  [[nodiscard]] T unlimited(T value) const;

  std::optional<Solid<T>> field_;
  bool isByDistance_ = false;
  // start + slope * (the field's value or its magnitude), clamped to least_ and most_
  T start_;
  T slope_ = 0;
  T least_;
  T most_;
  Guarantee<T> known_;
};

extern template class GradedValue<float>;
extern template class GradedValue<double>;

}  // namespace cutwater
