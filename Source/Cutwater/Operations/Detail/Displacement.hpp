#pragma once

#include <Cutwater/Operations/Detail/BinaryOperation.hpp>

namespace cutwater {

/// The operand with a user-defined function added to its value, e.g. for roughness or waves.
///
///     f(p) = g(p) + h(p)        Lipschitz constant L_g + L_h
///
/// The solid is where the value is negative: the surface moves out by about -h. Values are lower
/// bounds of the distance only if the constant is at most 1; box queries and crossings work with
/// any constant. Patches are the operand's.
template <std::floating_point T>
class Displacement final : public BinaryOperation<T> {
 public:
  /// `amplitude`: a bound of |h| everywhere; may be infinite.
  Displacement(Solid<T> operand, Solid<T> h, T amplitude);

 private:
  std::string localName() const override { return "Displacement"; }
  T combined(T a, T b) const override { return a + b; }
  Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  std::vector<std::string> localPatchNames() const override;

  T amplitude_;
};

extern template class Displacement<float>;
extern template class Displacement<double>;

}  // namespace cutwater
