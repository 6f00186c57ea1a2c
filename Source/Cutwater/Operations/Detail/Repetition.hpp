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
/// that distance, and f is at most
///
///     E + max(2 D - E / 4, 0),        E: the distance to the nearest bounding box
///
/// where D is the diagonal of a bounding box, or less if very many copies are that near. So the
/// value is that of one of a limited number of copies, wherever the point is, still continuous and
/// as good a bound as the operand's. With D the diagonal, this takes nothing from values up to four
/// diagonals from the copies, and at most a ninth beyond; from eight on, f is E.
///
/// Of an operand whose bounding box is empty, only the central copy is asked, and values have no
/// Lipschitz constant.
///
/// A query costs one query of the operand if it fills its box well and copies keep apart, and a few
/// otherwise: at most one for each bounding box within half a period along each axis, which are up
/// to 2 x 2 x 2 if boxes do not overlap. If the operand's values outside are not exact distances,
/// it is at most one for each box within about 3 D: a thousand, or twice as many as overlap at a
/// point if that is more, and none if f is E.
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
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  /// The deciding copy, as multiples of the period. Where f is the most that it may be, the best
  /// known.
  struct Decision {
    Vec3<T> copy;
    T value;
  };
  void checkArguments() const;
  void deriveReach();
  void deriveGuarantee();
  /// The copy whose box is centred nearest to a point; the point in its frame; and E, or 0 where
  /// that is not needed.
  struct Start {
    Vec3<T> copy;
    Vec3<T> local;
    T gap;
  };
  [[nodiscard]] Start startAt(const Vec3<T>& p) const;
  /// Whether f is at least E, and at most mostAt(E).
  [[nodiscard]] bool isLimited() const { return diagonal_ < Box<T>::kInf; }
  /// The most that f may be, given E.
  [[nodiscard]] T mostAt(T gap) const {
    return gap + std::max(2 * diagonal_ - T(0.25) * gap, T(0));
  }
  /// Whether f is E.
  [[nodiscard]] bool isFar(const Start& start) const {
    return isLimited() && start.gap >= 8 * diagonal_;
  }
  [[nodiscard]] T gapOf(const Vec3<T>& local) const { return length(copies_.gaps(local)); }
  /// The value of a copy, given the operand's and the distance to the copy's box.
  [[nodiscard]] T valueFrom(T value, T gap) const {
    return isLimited() && gap > 0 && value < gap ? gap : value;
  }
  /// The copy with the least value, given the operand's value in the frame of the start.
  [[nodiscard]] Decision decide(const Vec3<T>& p, const Start& start, T value) const;
  [[nodiscard]] Decision decide(const Vec3<T>& p) const;

  detail::Copies<T> copies_;  // of the operand's box
  typename detail::Copies<T>::Reach reach_;
  T diagonal_ = Box<T>::kInf;  // D; infinite for exact distances, and without a box
  Guarantee<T> guarantee_;
  T stretch_ = 1;  // no value is more than this many times the distance
};

extern template class Repetition<float>;
extern template class Repetition<double>;

}  // namespace cutwater
