#pragma once

#include <Cutwater/Operations/GradedValue.hpp>
#include <Cutwater/Tpms/TpmsPattern.hpp>

#include <memory>

namespace cutwater {

namespace detail {
class PatternDistance;
}  // namespace detail

/// The wall of even thickness about the surface F = 0 of a pattern in cubic cells: all points
/// within half the thickness, which is a length, of the surface. Endless, with nothing stored.
///
///     f(p) = (d(p) - h(p)) / (1 + L_h)        d: distance to the surface, h: half thickness
///
/// The distance d itself is found, not a bound of it: the zero set of a bound would be a wall that
/// is too thick, by 3 to 16 % for the gyroid. Beyond one and a half times the half thickness, lower
/// bounds of d are used instead. Values are lower bounds of the distance and 1-Lipschitz, apart
/// from tolerance(). A value takes about a microsecond if the surface curves less sharply than the
/// wall is thick. Otherwise, up to walls that leave next to nothing of a channel, it takes 10 to 60
/// microseconds on average, and up to a millisecond or two where a ball about the point touches the
/// surface in many places.
template <std::floating_point T>
class MetricWall final : public SignedDistanceFunction<T> {
 public:
  /// @throws Error unless cells are of ordinary size, and half the thickness is positive and less
  /// than the radius of the largest balls in the channels.
  MetricWall(TpmsPattern pattern, T cellSize, GradedValue<T> halfThickness);

  [[nodiscard]] const TpmsPattern& pattern() const { return pattern_; }
  [[nodiscard]] T cellSize() const { return cellSize_; }
  [[nodiscard]] const GradedValue<T>& halfThickness() const { return halfThickness_; }
  /// The tolerance to which distances are certain: nearly rounding if the surface curves less
  /// sharply than the wall is thick, and 10^-4 of a cell otherwise.
  [[nodiscard]] T tolerance() const;

 private:
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  std::string localName() const override;

  TpmsPattern pattern_;
  T cellSize_;
  GradedValue<T> halfThickness_;
  double reach_;      // how far from the surface distances are found; in radians
  double tolerance_;  // in radians
  std::shared_ptr<const detail::PatternDistance> distance_;
  Guarantee<T> guarantee_;
};

extern template class MetricWall<float>;
extern template class MetricWall<double>;

}  // namespace cutwater
