#pragma once

#include <Cutwater/Operations/Tiles.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The union of copies of the operand at multiples of a period.
///
///     f(p) = min_n g(p - n period)
///
/// The nearest copy is found whatever the operand's shape: not only the one whose bounding box is
/// centred nearest to the point, but all whose bounding box is nearer than the best so far. Outside
/// it is as good as the operand; inside, too, if the bounding boxes of neighbours keep apart, else
/// a lower bound. Where the operand's values outside are no exact distances, those less than the
/// distance to its bounding box count as that.
///
/// A query costs one of the operand if that fills its box well and copies keep apart, a few if not:
/// at most as many as bounding boxes are within the distance to the nearest copy. With periods of
/// very different length, or far away from a sheet or block of copies, those may be many.
///
/// @throws Error unless periods are finite and not negative, one is positive, the bounding box is
/// finite along it, and there is one copy where it is 0. Error of kind Limit, if more than 10^5
/// bounding boxes overlap at one point.
template <std::floating_point T>
class Repetition final : public UnaryOperation<T> {
 public:
  Repetition(Solid<T> operand, const Repeats<T>& repeats);

 private:
  [[nodiscard]] std::string localName() const override { return "Repetition"; }
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override { return guarantee_; }
  [[nodiscard]] Box<T> localBoundingBox() const override;
  [[nodiscard]] Box<T> localClearanceBox() const override;

  /// The copy that decides, by the multiples of the period.
  struct Decision {
    Vec3<T> copy;
    T value;
  };
  void checkArguments() const;
  void deriveGuarantee();
  /// Of the copy that sees the point at `local`, from the operand's value.
  [[nodiscard]] T valueFrom(const Vec3<T>& local, T value) const;
  /// The copy of least value, if that of the central one is known.
  [[nodiscard]] Decision decide(const Vec3<T>& p, const Decision& central) const;
  [[nodiscard]] Decision decide(const Vec3<T>& p) const;

  detail::Tiles<T> tiles_;  // of the operand's box
  Guarantee<T> guarantee_;
  T stretch_ = 1;  // no value is more than so many times the distance
  bool isClamped_ = false;
};

extern template class Repetition<float>;
extern template class Repetition<double>;

}  // namespace cutwater
