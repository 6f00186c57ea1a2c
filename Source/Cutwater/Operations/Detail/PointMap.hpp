#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand evaluated at another point: f(p) = factor g(q(p)).
///
/// A subclass defines the map q and its properties. Owners, patches and bounds are then those of
/// the operand at q; closest points and crossings are found from values.
template <std::floating_point T>
class PointMap : public UnaryOperation<T> {
 protected:
  explicit PointMap(Solid<T> operand) : UnaryOperation<T>(std::move(operand)) {}

  /// q(p).
  [[nodiscard]] virtual Vec3<T> mapped(const Vec3<T>& p) const = 0;
  /// Encloses the image of every point of the box, both exact and as computed.
  [[nodiscard]] virtual OrientedBox<T> mapped(const OrientedBox<T>& box) const = 0;
  /// The gradient of g(q(p)) at p, given that of g at q(p): the transposed derivative of q times
  /// `gradient`.
  [[nodiscard]] virtual Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const = 0;
  [[nodiscard]] virtual T factor() const { return 1; }

  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
};

extern template class PointMap<float>;
extern template class PointMap<double>;

}  // namespace cutwater
