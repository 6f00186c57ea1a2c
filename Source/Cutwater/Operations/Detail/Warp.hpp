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
class Warp : public PointMap<T> {
 protected:
  /// @throws Error unless the limits are finite or none, and not negative.
  Warp(Solid<T> operand, const FunctionLimits<T>& limits);

  /// v(p).
  [[nodiscard]] virtual Vec3<T> shift(const Vec3<T>& p) const = 0;

 private:
  std::string localName() const final { return "Warp"; }
  Vec3<T> mapped(const Vec3<T>& p) const final { return p + shift(p); }
  OrientedBox<T> mapped(const OrientedBox<T>& box) const final;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const final;
  Guarantee<T> localGuarantee() const final;
  Box<T> localBoundingBox() const final;

  FunctionLimits<T> limits_;
};

/// The same with any callable that takes a point and returns a shift. It is called from several
/// threads at once and must not throw.
template <std::floating_point T, typename Function>
class WarpBy final : public Warp<T> {
 public:
  WarpBy(Solid<T> operand, Function function, const FunctionLimits<T>& limits)
      : Warp<T>(std::move(operand), limits), function_(std::move(function)) {}

 private:
  Vec3<T> shift(const Vec3<T>& p) const override { return function_(p); }

  Function function_;
};

extern template class Warp<float>;
extern template class Warp<double>;

}  // namespace cutwater
