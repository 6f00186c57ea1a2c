#pragma once

#include <Cutwater/Operations/BinaryOperation.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

namespace cutwater {

/// The operand with a function of the user's own added to its value: roughness, waves.
///
///     f(p) = g(p) + h(p)        Lipschitz constant L_g + L_h
///
/// The solid is where the value is negative: the surface moves out by about -h. Values are lower
/// bounds of the distance only if the constant is at most 1; for boxes and crossings, any constant
/// will do. Patches are the operand's.
template <std::floating_point T>
class Displacement final : public BinaryOperation<T> {
 public:
  /// |h| <= amplitude everywhere, which may be infinite.
  Displacement(Solid<T> operand, Solid<T> h, T amplitude);

 private:
  [[nodiscard]] std::string localName() const override { return "Displacement"; }
  [[nodiscard]] T combined(T a, T b) const override { return a + b; }
  [[nodiscard]] Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const override;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override;
  [[nodiscard]] Box<T> localBoundingBox() const override;
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;

  T amplitude_;
};

extern template class Displacement<float>;
extern template class Displacement<double>;

namespace detail {

/// @throws Error, as from the operator `name`, unless the limits are finite or none, and not
/// negative.
template <std::floating_point T>
void requireLimits(const char* name, const FunctionLimits<T>& limits);

/// What a function within the limits promises as a solid, if its value at the origin is this.
template <std::floating_point T>
[[nodiscard]] Guarantee<T> guaranteeOf(const FunctionLimits<T>& limits, T atOrigin);

}  // namespace detail

}  // namespace cutwater
