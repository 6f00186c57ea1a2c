#pragma once

#include <Cutwater/Core/Detail/Copies.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The union of copies of the operand at multiples of a period.
///
///     f(p) = min_n g(p - n period)
///
/// The nearest copy is found whatever the operand's shape: not only the copy whose bounding box is
/// centred nearest to the point is tried, but every copy whose bounding box is nearer than the best
/// value so far. Values outside are as good as the operand's. So are values inside if the bounding
/// boxes of neighbours keep apart; otherwise they are lower bounds. Where the operand's values
/// outside are not exact distances, any less than the distance to its bounding box is replaced by
/// that distance.
///
/// Of an operand whose bounding box is empty, only the central copy is asked, and values have no
/// Lipschitz constant.
///
/// A query costs one query of the operand if it fills its box well and copies keep apart, and a few
/// otherwise: at most one for each bounding box within the distance to the nearest copy. With
/// periods of very different lengths, or far away from a sheet or block of copies, these may be
/// many.
///
/// @throws Error unless periods are finite and not negative, at least one is positive, the bounding
/// box is finite along repeated axes, and there is only one copy along axes of period 0. Error of
/// kind Limit if more than 10^5 bounding boxes overlap at one point.
template <std::floating_point T>
class Repetition final : public UnaryOperation<T> {
 public:
  Repetition(Solid<T> operand, const Repeats<T>& repeats);

 private:
  std::string localName() const override { return "Repetition"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  /// The deciding copy, as multiples of the period.
  struct Decision {
    Vec3<T> copy;
    T value;
  };
  void checkArguments() const;
  void deriveGuarantee();
  /// The value of the copy in whose frame the point is `local`, given the operand's value there.
  [[nodiscard]] T valueFrom(const Vec3<T>& local, T value) const;
  /// The copy with the least value, given the value of the central one.
  [[nodiscard]] Decision decide(const Vec3<T>& p, const Decision& central) const;
  [[nodiscard]] Decision decide(const Vec3<T>& p) const;

  detail::Copies<T> copies_;  // of the operand's box
  Guarantee<T> guarantee_;
  T stretch_ = 1;  // no value is more than this many times the distance
  bool isClamped_ = false;
};

extern template class Repetition<float>;
extern template class Repetition<double>;

}  // namespace cutwater
