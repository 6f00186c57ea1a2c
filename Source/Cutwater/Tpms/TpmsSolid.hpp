#pragma once

#include <Cutwater/Tpms/TpmsField.hpp>

namespace cutwater {

/// The part of a field F that is solid, with a level h in units of F.
enum class TpmsPart : std::uint8_t {
  Wall,      ///< |F| < h
  Channels,  ///< |F| > h: all that is not wall
  ChannelA,  ///< F > h; with h = 0, half of space, a network
  ChannelB,  ///< F < -h
  WallInA,   ///< 0 < F < h: the half of the wall on the side of A
  WallInB,   ///< -h < F < 0
};

/// A triply periodic wall or network, defined by levels of a field: endless, with nothing stored.
///
///     const TpmsSolid<double> wall(TpmsField<double>(TpmsPattern::gyroid(), 5), TpmsPart::Wall,
///     0.3);
///
/// Values are lower bounds of the distance, and 1-Lipschitz; box queries are certain. Where parts
/// of one field and level meet, their values are the same apart from the sign, so the solids fit to
/// the bit: a point belongs to only one of them, or lies within rounding of both.
template <std::floating_point T>
class TpmsSolid final : public SignedDistanceFunction<T> {
 public:
  /// @throws Error unless the level leaves the part intact: a wall needs 0 < h, and h less than
  /// TpmsPattern::pinch(), where the channels beside it break up; a channel needs h less than its
  /// own pinch() and more than minus the other's.
  TpmsSolid(TpmsField<T> field, TpmsPart part, GradedValue<T> level);

  [[nodiscard]] const TpmsField<T>& field() const { return field_; }
  [[nodiscard]] TpmsPart part() const { return part_; }
  [[nodiscard]] const GradedValue<T>& level() const { return level_; }

 private:
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  void localCrossingsOfEach(std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                            CrossingsVisitor<T> visit) const override {
    this->crossingsByValues(segments, counts, visit);
  }
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  std::string localName() const override;

  TpmsField<T> field_;
  TpmsPart part_;
  GradedValue<T> level_;
  Guarantee<T> guarantee_;
};

extern template class TpmsSolid<float>;
extern template class TpmsSolid<double>;

}  // namespace cutwater
