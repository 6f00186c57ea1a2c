#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand grown by a distance, with its convex edges rounded; or shrunk, if the distance is
/// negative.
///
///     f(p) = g(p) - distance
///
/// Growing keeps the values outside exact, and shrinking those inside. The others become lower
/// bounds if the operand's Lipschitz constant is at most 1; if not, only their sign is right. Where
/// the operand's own values are not exact distances, the solid is {g < distance}.
///
/// @throws Error unless the distance is finite.
template <std::floating_point T>
class Offset final : public UnaryOperation<T> {
 public:
  Offset(Solid<T> operand, T distance);

 private:
  std::string localName() const override {
    return "Offset by " + detail::toText(double{distance_});
  }
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override { return this->operand().gradient(p); }
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  T distance_;
};

extern template class Offset<float>;
extern template class Offset<double>;

}  // namespace cutwater
