#pragma once

#include <Cutwater/Operations/Detail/Images.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// Base of operators that pass nearly every query on to their operand, perhaps in another place,
/// and hand back its answer, perhaps changed.
///
/// A derived class defines those of the functions below that differ from "in the same place" and
/// "unchanged", as private members with this class as a friend. They are found at compile time: a
/// query costs no more than one written out by hand.
template <std::floating_point T, typename Derived>
class Forwarding : public UnaryOperation<T> {
 protected:
  explicit Forwarding(Solid<T> operand) : UnaryOperation<T>(std::move(operand)) {}

  // The query. Whether points are moved at all must be said, because batches are then copied.
  static constexpr bool kMovesPoints = false;
  [[nodiscard]] const Vec3<T>& place(const Vec3<T>& p) const { return p; }
  [[nodiscard]] const OrientedBox<T>& place(const OrientedBox<T>& box) const { return box; }
  /// The operand's values that give a value within `wanted`, or some more.
  [[nodiscard]] Interval<T> wantedOfOperand(const Interval<T>& wanted) const { return wanted; }

  // The answer.
  [[nodiscard]] T value(T ofOperand) const { return ofOperand; }
  [[nodiscard]] Interval<T> range(const Interval<T>& ofOperand) const { return ofOperand; }
  [[nodiscard]] BoxClass kind(BoxClass ofOperand) const { return ofOperand; }
  void turn(Vec3<T>& /*direction*/) const {}
  /// `p`: the point of the query, before it was moved.
  void adjust(SurfacePoint<T>& /*found*/, const Vec3<T>& /*p*/) const {}
  void adjust(Crossing<T>& /*found*/) const {}

  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override {
    const Segment<T> moved{self().place(segment.start), self().place(segment.end)};
    return this->operand().crossings(moved, [&](Crossing<T> crossing) {
      self().adjust(crossing);
      return visit(crossing);
    });
  }

 private:
  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }

  T localSignedDistance(const Vec3<T>& p) const final {
    return self().value(this->operand().signedDistance(self().place(p)));
  }
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const final {
    return self().value(
        this->operand().signedDistanceWithin(self().place(p), self().wantedOfOperand(wanted)));
  }
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final {
    forPlaces(points, [&](std::span<const Vec3<T>> places, std::size_t first) {
      const auto values = distances.subspan(first, places.size());
      this->operandValues(places, values);
      for (auto& each : values) each = self().value(each);
    });
  }
  Vec3<T> localGradient(const Vec3<T>& p) const final {
    auto gradient = this->operand().gradient(self().place(p));
    self().turn(gradient);
    return gradient;
  }
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const final {
    auto found = this->operand().closestPoint(self().place(p));
    self().adjust(found, p);
    return found;
  }
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const final {
    forPlaces(points, [&](std::span<const Vec3<T>> places, std::size_t first) {
      const auto some = results.subspan(first, places.size());
      this->operandPoints(places, some);
      for (std::size_t i = 0; i < some.size(); ++i) self().adjust(some[i], points[first + i]);
    });
  }
  SurfaceOwner localOwner(const Vec3<T>& p) const final {
    return this->operand().owner(self().place(p));
  }
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const final {
    return self().range(this->boundsOf(this->operand(), self().place(box), hint));
  }
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const final {
    return self().kind(this->classOf(this->operand(), self().place(box), hint));
  }

  template <typename Batch>
  void forPlaces(std::span<const Vec3<T>> points, const Batch& batch) const {
    if constexpr (Derived::kMovesPoints) {
      detail::forImages(
          points, [this](const Vec3<T>& p) { return self().place(p); }, batch);
    } else {
      batch(points, 0);
    }
  }
};

}  // namespace cutwater
