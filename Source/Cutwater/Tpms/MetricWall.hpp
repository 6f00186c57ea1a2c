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
/// d is the distance itself, not a bound: a wall made from a bound would be too thick, by 3 to 16 %
/// for the gyroid. Where d is more than 1.5 times half the thickness, lower bounds of it are used.
/// Values are lower bounds of the distance and 1-Lipschitz, apart from tolerance(). A value of a
/// thin wall takes about a microsecond; half its thickness, in radians (a cell is 2 pi), is less
/// than 0.64 leastSlope() / curvature() of the pattern, a bound of the surface's radius of
/// curvature. Thicker walls, up to those that almost fill a channel, take 10 to 60 microseconds on
/// average, and up to 2 ms at points that many places of the surface are equally near to.
template <std::floating_point T>
class MetricWall final : public SignedDistanceFunction<T> {
 public:
  /// @throws Error unless 0 < cellSize < infinity and 1 / cellSize is finite, and half the
  /// thickness is positive and less than the radius of the largest ball in either channel.
  MetricWall(TpmsPattern pattern, T cellSize, GradedValue<T> halfThickness);

  [[nodiscard]] const TpmsPattern& pattern() const { return pattern_; }
  [[nodiscard]] T cellSize() const { return cellSize_; }
  [[nodiscard]] const GradedValue<T>& halfThickness() const { return halfThickness_; }
  /// The tolerance to which distances are certain: 1.6e-10 of a cell for thin walls, as above, and
  /// 1e-4 of a cell otherwise.
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
