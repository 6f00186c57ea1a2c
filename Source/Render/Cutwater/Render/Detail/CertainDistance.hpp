#pragma once

#include <Cutwater/Sdf/Guarantee.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// A certain lower bound on the distance to the surface, from a solid's guarantee: the value where
/// that is a distance or a lower bound of one, the value over the Lipschitz constant where there is
/// one.
template <std::floating_point T>
class CertainDistance {
 public:
  /// `box`: the region of all queries. `sheets`: values of both signs are distances.
  CertainDistance(const Guarantee<T>& guarantee, const Box<double>& box, bool sheets);

  /// Whether values give more than their sign.
  [[nodiscard]] bool isKnown() const { return factor_ > 0; }
  /// Whether the bound is the distance, up to rounding.
  [[nodiscard]] bool isExact() const { return exact_; }
  /// The bound at a point with this value; not positive inside or within round-off of the surface.
  /// If the effect of rounding may exceed `most`, rounding is ignored.
  [[nodiscard]] double operator()(T value, const Vec3<T>& p, double most) const {
    const double size{sheets_ && value < 0 ? -value : value};
    return factor_ * (size - rounding(p, most));
  }
  /// Whether the point is inside by more than rounding; `most` as above.
  [[nodiscard]] bool isInside(T value, const Vec3<T>& p, double most) const {
    return static_cast<double>(value) < -rounding(p, most);
  }

 private:
  [[nodiscard]] double rounding(const Vec3<T>& p, double most) const {
    const double error{guarantee_.error(length(p))};
    return factor_ * error <= most ? error : 0;
  }

  Guarantee<T> guarantee_;
  bool sheets_;
  bool exact_;
  double factor_ = 0;
};

extern template class CertainDistance<float>;
extern template class CertainDistance<double>;

}  // namespace cutwater::detail
