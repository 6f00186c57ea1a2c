#pragma once

#include <Cutwater/Operations/GradedValue.hpp>
#include <Cutwater/Tpms/TpmsMap.hpp>
#include <Cutwater/Tpms/TpmsPattern.hpp>

namespace cutwater {

namespace detail {
template <std::floating_point T>
struct PartTerms;
template <std::floating_point T>
struct LevelTerms;
}  // namespace detail

/// A transition from one pattern to another: (1 - w) F1 + w F2.
template <std::floating_point T>
struct TpmsTransition {
  TpmsPattern from;
  TpmsPattern to;
  /// From 0, which gives `from` alone, to 1.
  GradedValue<T> weight;
};

/// A pattern in space: a level function of position, with guaranteed bounds of its changes. A value
/// type.
///
///     TpmsField<double>(TpmsPattern::gyroid(), 5)                       // cubic cells
///     TpmsField<double>(TpmsPattern::gyroid(), TpmsMap<double>::cylindrical({5, 12, 5}))
///     TpmsField<double>(TpmsTransition<double>{gyroid, schwarzP, weight}, 5)
///
/// Lower bounds of the distance to a level are found in two ways. For a uniform field, i.e. a
/// single pattern in cells of constant size along each axis, they follow from its second
/// derivatives (see Docs/tpms.md). Otherwise the bound is the radius of the largest ball in which
/// the pattern, as seen through the map, cannot change by enough to reach the level.
template <std::floating_point T>
class TpmsField {
 public:
  TpmsField(TpmsPattern pattern, TpmsMap<T> map);
  /// @throws Error unless weights are within [0, 1].
  TpmsField(TpmsTransition<T> transition, TpmsMap<T> map);

  /// The level function F at a point.
  [[nodiscard]] T value(const Vec3<T>& p) const;
  /// Its gradient; of a field that is not uniform, by differences.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& p) const;
  /// A bound of the gradient's length anywhere; infinite unless the field is uniform.
  [[nodiscard]] T steepness() const;

  /// Lower bound of the distance to the surface of a part, for the field F and a level h, which may
  /// depend on position: to psi = 0, with the sign of psi, the function of F and h that is negative
  /// in the part. 1-Lipschitz.
  [[nodiscard]] T distance(const detail::PartTerms<T>& part, const GradedValue<T>& level,
                           const Vec3<T>& p) const;
  /// The same, to the bit, for 64 points or fewer.
  void distances(const detail::PartTerms<T>& part, const GradedValue<T>& level,
                 std::span<const Vec3<T>> points, std::span<T> result) const;
  /// Encloses these numbers in a box, of a uniform field: from F and its gradient at the centre,
  /// and the greatest second derivative.
  [[nodiscard]] Interval<T> distancesIn(const detail::PartTerms<T>& part,
                                        const GradedValue<T>& level,
                                        const OrientedBox<T>& box) const;
  /// The guarantee of these bounds.
  [[nodiscard]] Guarantee<T> guarantee(const GradedValue<T>& level) const;

  /// Whether this is a single pattern in cells of constant size along each axis.
  [[nodiscard]] bool isUniform() const { return uniform_.has_value(); }
  [[nodiscard]] const TpmsPattern& pattern() const { return from_; }
  [[nodiscard]] const TpmsMap<T>& map() const { return map_; }
  /// The least TpmsPattern::pinch() of the patterns; between two patterns, channels may fall apart
  /// at smaller levels.
  [[nodiscard]] double pinch(TpmsChannel channel) const;
  [[nodiscard]] std::string name() const;

 private:
  /// Data of a pattern in cells of constant size.
  struct UniformCells {
    Vec3<T> rates;  // cells per length
    Vec3<T> weight;
    T lipschitz;
    T lengthPerRadian;
  };

  [[nodiscard]] detail::LevelTerms<T> terms(const detail::PartTerms<T>& part,
                                            const GradedValue<T>& level) const;
  [[nodiscard]] Interval<T> valuesIn(const OrientedBox<T>& box) const;
  [[nodiscard]] T lipschitzWithin(const Vec3<T>& p, T radius) const;
  [[nodiscard]] T freeRadius(T change, const GradedValue<T>& level, const Vec3<T>& p) const;

  TpmsPattern from_;
  TpmsPattern to_;
  std::optional<GradedValue<T>> weight_;
  T mostDifference_ = 0;  // an upper bound of |F1 - F2|
  TpmsMap<T> map_;
  std::optional<UniformCells> uniform_;
};

extern template class TpmsField<float>;
extern template class TpmsField<double>;

}  // namespace cutwater
