#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/BinaryOperation.hpp>

namespace cutwater {

/// A solid between two others.
///
///     f(p) = (1 - t) a(p) + t b(p)
///
/// The solid is where the value is negative. Values are lower bounds on both sides if the operands'
/// Lipschitz constants satisfy (1 - t) L_a + t L_b <= 1.
///
/// @throws Error unless 0 <= t <= 1.
template <std::floating_point T>
class Blend final : public BinaryOperation<T> {
 public:
  Blend(Solid<T> a, Solid<T> b, T t);

 private:
  std::string localName() const override { return "Blend at " + detail::toText(double{t_}); }
  T combined(T a, T b) const override;
  Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override { return this->clearanceOfBoth(); }

  T t_;
};

extern template class Blend<float>;
extern template class Blend<double>;

}  // namespace cutwater
