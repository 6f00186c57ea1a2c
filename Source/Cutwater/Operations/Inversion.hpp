#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand's image under inversion in the unit sphere about the origin, q(p) = p / |p|^2: what
/// is near the origin goes far away, planes and spheres become spheres.
///
///     |f(p)| = D |p| / min(1 / |p| + D, R),        D = |g(q)|, f negative where g(q) is
///
/// is a lower bound of the distance if D is one, because distances behave as
/// |p - y| = |q(p) - q(y)| |p| / |q(y)|, and the nearest surface point y of the image has a |q(y)|
/// of at most 1/|p| + D, and of at most R, the radius about the origin of a ball that holds the
/// operand's surface. R counts for operands that are exact on both sides and have a finite bounding
/// box; about the origin, D is then at least 1/|p| - R. D is |g| / L where |g| is no bound but has
/// a Lipschitz constant L. (The popular g(q) |p|^2 is far more than the distance where |p| is
/// large.)
///
/// The origin itself stands for infinity: outside, for a bounded operand; else of value 0. Where
/// the operand's surface passes close to the origin, rounding grows with |p|^2 and
/// guarantee().domain ends at 32 operand sizes' reciprocals.
template <std::floating_point T>
class Inversion final : public UnaryOperation<T> {
 public:
  explicit Inversion(Solid<T> operand);

 private:
  [[nodiscard]] std::string localName() const override { return "Inversion"; }
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override { return guarantee_; }
  [[nodiscard]] Box<T> localBoundingBox() const override { return boundingBox_; }

  void deriveGuarantee();
  void deriveBoundingBox();
  /// Whether p counts as the origin.
  [[nodiscard]] bool isOrigin(T radius) const;
  [[nodiscard]] T valueAtOrigin() const {
    return surfaceRadius_ < Box<T>::kInf ? 1 / surfaceRadius_ : T(0);
  }
  /// D, from the operand's value.
  [[nodiscard]] T bound(T value, T radius) const;
  /// f, from the operand's value at q(p), where |p| is `radius`.
  [[nodiscard]] T valueFrom(T value, T radius) const;

  T surfaceRadius_ = Box<T>::kInf;  // R
  T divisor_ = 1;                   // of |g|, that makes it D
  T distanceAtOrigin_ = 0;          // D there, if it can change by no more than the distance
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
};

extern template class Inversion<float>;
extern template class Inversion<double>;

}  // namespace cutwater
