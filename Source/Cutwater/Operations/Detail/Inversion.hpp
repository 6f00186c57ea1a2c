#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand's image under inversion in the unit sphere about the origin, q(p) = p / |p|^2.
/// Points near the origin move far away; planes and spheres become spheres.
///
///     |f(p)| = D |p| / min(1 / |p| + D, R),        D = |g(q)|, f negative where g(q) is
///
/// is a lower bound of the distance if D is one. Distances behave as
/// |p - y| = |q(p) - q(y)| |p| / |q(y)|, and for the nearest surface point y of the image, |q(y)|
/// is at most 1/|p| + D and at most R, the radius of a ball about the origin that encloses the
/// operand's surface. R is used for operands that are exact on both sides and have a finite
/// bounding box; near the origin, D is then at least 1/|p| - R. If |g| is not a bound but has a
/// Lipschitz constant L, D is |g| / L. (The popular g(q) |p|^2 is far more than the distance where
/// |p| is large.)
///
/// The origin itself stands for infinity: it is outside if the operand is bounded, and has value 0
/// otherwise. Where the operand's surface passes close to the origin, rounding grows with |p|^2,
/// and guarantee().domain ends at 32 / (the operand's size).
template <std::floating_point T>
class Inversion final : public UnaryOperation<T> {
 public:
  explicit Inversion(Solid<T> operand);

 private:
  std::string localName() const override { return "Inversion"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override { return boundingBox_; }

  void deriveGuarantee();
  void deriveBoundingBox();
  /// Whether a point at this radius counts as the origin.
  [[nodiscard]] bool isOrigin(T radius) const;
  [[nodiscard]] T valueAtOrigin() const {
    return surfaceRadius_ < Box<T>::kInf ? 1 / surfaceRadius_ : T(0);
  }
  /// D, given the operand's value.
  [[nodiscard]] T bound(T value, T radius) const;
  /// f, given the operand's value at q(p), where |p| is `radius`.
  [[nodiscard]] T valueFrom(T value, T radius) const;

  T surfaceRadius_ = Box<T>::kInf;  // R
  T divisor_ = 1;                   // D = |g| / divisor_
  T distanceAtOrigin_ = 0;          // a lower bound of D there, if D is 1-Lipschitz; else 0
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
};

extern template class Inversion<float>;
extern template class Inversion<double>;

}  // namespace cutwater
