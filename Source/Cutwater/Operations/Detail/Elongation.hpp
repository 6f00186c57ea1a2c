#pragma once

#include <Cutwater/Operations/Detail/PointMap.hpp>

namespace cutwater {

/// The operand cut at the planes x = 0, y = 0 and z = 0, with its parts moved apart by `half` to
/// either side and the gaps filled with the cross-sections: a ball becomes a capsule, a ring a
/// link.
///
///     f(p) = g(p - clamp(p, -half, half))        a lower bound if the operand's value is one
///
/// Outside, it is in fact exact for an exact operand that is convex and symmetric about the planes.
/// @throws Error unless `half` is finite and not negative on any axis.
template <std::floating_point T>
class Elongation final : public PointMap<T> {
 public:
  Elongation(Solid<T> operand, const Vec3<T>& half);

 private:
  std::string localName() const override { return "Elongation"; }
  Vec3<T> mapped(const Vec3<T>& p) const override;
  OrientedBox<T> mapped(const OrientedBox<T>& box) const override;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  Vec3<T> half_;
};

extern template class Elongation<float>;
extern template class Elongation<double>;

}  // namespace cutwater
