#pragma once

#include <Cutwater/Operations/Detail/PointMap.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

namespace cutwater {

/// The operand evaluated at points that a user-defined function shifts: bent, twisted, swirled.
///
///     f(p) = g(p + v(p))        Lipschitz constant L_g (1 + L_v)
///
/// The solid is where the value is negative: the surface moves by about -v. If the constant is more
/// than 1, values are not bounds of the distance, but box queries and crossings are certain all the
/// same. Patches are the operand's.
template <std::floating_point T>
class Warp final : public PointMap<T> {
 public:
  /// @throws Error unless the limits are finite or none, and not negative.
  Warp(Solid<T> operand, detail::PointShift<T> shift, const FunctionLimits<T>& limits);

 private:
  std::string localName() const override { return "Warp"; }
  Vec3<T> mapped(const Vec3<T>& p) const override { return p + shift_(p); }
  OrientedBox<T> mapped(const OrientedBox<T>& box) const override;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  detail::PointShift<T> shift_;  // v
  FunctionLimits<T> limits_;
};

extern template class Warp<float>;
extern template class Warp<double>;

}  // namespace cutwater
