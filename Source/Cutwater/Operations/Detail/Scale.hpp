#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand `factor` times as large about the origin; a negative factor also mirrors it through
/// the origin.
///
///     f(p) = |factor| g(p / factor)        keeps what the operand guarantees
///
/// @throws Error unless the factor and its reciprocal are finite.
template <std::floating_point T>
class Scale final : public UnaryOperation<T> {
 public:
  Scale(Solid<T> operand, T factor);

 private:
  std::string localName() const override { return "Scaled by " + detail::toText(double{factor_}); }
  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  [[nodiscard]] Vec3<T> mirrored(const Vec3<T>& direction) const;
  [[nodiscard]] Box<T> image(const Box<T>& box) const;
  [[nodiscard]] OrientedBox<T> shrunk(const OrientedBox<T>& box) const;
  /// The operand's result for `p`, scaled to this solid's size.
  [[nodiscard]] SurfacePoint<T> grown(SurfacePoint<T> found, const Vec3<T>& p) const;

  T factor_;
};

extern template class Scale<float>;
extern template class Scale<double>;

}  // namespace cutwater
