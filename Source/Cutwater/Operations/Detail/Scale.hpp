#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Forwarding.hpp>

namespace cutwater {

/// The operand `factor` times as large about the origin; a negative factor also mirrors it through
/// the origin.
///
///     f(p) = |factor| g(p / factor)        keeps what the operand guarantees
///
/// @throws Error unless the factor and its reciprocal are finite.
template <std::floating_point T>
class Scale final : public Forwarding<T, Scale<T>> {
 public:
  Scale(Solid<T> operand, T factor);

 private:
  friend Forwarding<T, Scale<T>>;
  static constexpr bool kMovesPoints = true;
  [[nodiscard]] Vec3<T> place(const Vec3<T>& p) const { return p / factor_; }
  [[nodiscard]] OrientedBox<T> place(const OrientedBox<T>& box) const;
  [[nodiscard]] Interval<T> wantedOfOperand(const Interval<T>& wanted) const {
    return this->wantedOverFactor(wanted, std::abs(factor_));
  }
  [[nodiscard]] T value(T ofOperand) const { return std::abs(factor_) * ofOperand; }
  [[nodiscard]] Interval<T> range(const Interval<T>& ofOperand) const;
  void turn(Vec3<T>& direction) const {
    if (factor_ < 0) direction = -direction;
  }
  void adjust(SurfacePoint<T>& found, const Vec3<T>& p) const;
  void adjust(Crossing<T>& found) const;

  std::string localName() const override { return "Scaled by " + detail::toText(double{factor_}); }
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override { return image(this->operand().boundingBox()); }
  Box<T> localClearanceBox() const override { return image(this->operand().clearanceBox()); }

  [[nodiscard]] Box<T> image(const Box<T>& box) const;

  T factor_;
};

extern template class Scale<float>;
extern template class Scale<double>;

}  // namespace cutwater
