#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// A wall around the operand's surface, `halfThickness` to either side.
///
///     f(p) = |g(p)| - halfThickness
///
/// If the operand's value is exact on both sides, the shell's is exact outside the wall, including
/// in the hollow, and a lower bound inside the wall. If not, the wall is {|g| < halfThickness}, and
/// values are lower bounds if the operand's Lipschitz constant is at most 1.
///
/// @throws Error unless 0 < halfThickness < infinity.
template <std::floating_point T>
class Shell final : public UnaryOperation<T> {
 public:
  Shell(Solid<T> operand, T halfThickness);

 private:
  std::string localName() const override {
    return "Shell of " + detail::toText(double{halfThickness_}) + " to either side";
  }
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  T halfThickness_;
};

extern template class Shell<float>;
extern template class Shell<double>;

}  // namespace cutwater
