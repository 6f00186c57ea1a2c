#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Sdf/Detail/BoxDescent.hpp>

#include <algorithm>
#include <array>

namespace cutwater::detail {

namespace {

template <std::floating_point T>
constexpr T kInf = std::numeric_limits<T>::infinity();

/// Rounding of a tangent plane, in units of error() at the farthest point of the box: that of the
/// value (1); twice the distance of the point at which the gradient is right, where the value and
/// the plane each change by it (2); that distance again in the term of k, as k |box| <= 1 (2); the
/// place itself, the length of the gradient, products and sums (16 eps of the size, 2 at most, as
/// error() is at least 8); the exact value in place of computed ones elsewhere (1). A power of two
/// above the sum.
constexpr int kRoundings = 16;

/// A place in the box: lengths along its half axes.
template <std::floating_point T>
using Place = std::array<T, 3>;

template <std::floating_point T>
class Descent {
 public:
  Descent(const Slopes<T>& slopes, const OrientedBox<T>& box, std::optional<T> concavity)
      : slopes_(slopes), box_(box), radius_(box.radius()) {
    for (std::size_t i = 0; i < 3; ++i) {
      extent_[i] = length(box.halfAxis[i]);
      if (extent_[i] > 0) axis_[i] = box.halfAxis[i] / extent_[i];
    }
    margin_ = kRoundings * slopes.guarantee.error(length(box.center) + radius_);
    if (concavity && *concavity * radius_ <= 1) concavity_ = concavity;
  }

  Interval<T> run(T atCenter) {
    Place<T> place{};
    T value = atCenter;
    found_ = {-kInf<T>, value};
    Place<T> before{};
    Place<T> slopeBefore{};
    bool hasMoved = false;
    for (int step = 0; step < kMostSteps; ++step) {
      const auto slope = slopeAt(place);
      if (!std::isfinite(value) || slope == Place<T>{}) break;
      bound(place, value, slope);
      if (found_.upper - found_.lower <= margin_) break;
      // First to just beyond the surface, as that may be all that is asked for.
      const T stride = hasMoved ? strideAfter(place, before, slope, slopeBefore)
                                : std::abs(value) + margin_ + 2 * box_.slack;
      before = place;
      slopeBefore = slope;
      for (std::size_t i = 0; i < 3; ++i) {
        place[i] = std::clamp(place[i] - stride * slope[i], -extent_[i], extent_[i]);
      }
      const auto point = pointAt(place);
      if (place == before || !isFinite(point)) break;
      hasMoved = true;
      value = slopes_.value(point);
      if (value < found_.upper) found_.upper = value;
    }
    return found_;
  }

 private:
  static constexpr int kMostSteps = 10;

  [[nodiscard]] Vec3<T> pointAt(const Place<T>& place) const {
    return box_.center + place[0] * axis_[0] + place[1] * axis_[1] + place[2] * axis_[2];
  }
  [[nodiscard]] Place<T> slopeAt(const Place<T>& place) const {
    const auto gradient = slopes_.gradient(pointAt(place));
    return {dot(gradient, axis_[0]), dot(gradient, axis_[1]), dot(gradient, axis_[2])};
  }

  /// The least value of the tangent plane in the box.
  void bound(const Place<T>& place, T value, const Place<T>& slope) {
    if (!concavity_) return;
    T least = value;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto change = [&](T end) {
        const T way = end - place[i];
        return slope[i] * way - T(0.5) * *concavity_ * way * way;
      };
      least += std::min(change(-extent_[i]), change(extent_[i]));
    }
    // The slack is a way in any direction, along which the plane and the term change by as much.
    least -= margin_ + 4 * box_.slack;
    if (least > found_.lower) found_.lower = least;
  }

  [[nodiscard]] T strideAfter(const Place<T>& place, const Place<T>& before, const Place<T>& slope,
                              const Place<T>& slopeBefore) const {
    T way = 0;
    T change = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const T d = (place[i] - before[i]) / radius_;
      way += d * d;
      change += d * (slope[i] - slopeBefore[i]);
    }
    // Across the whole box, where the function is as good as linear.
    constexpr T kFar = 1024;
    const T stride = way / change;
    return (stride > 0 && stride < kFar ? stride : kFar) * radius_;
  }

  const Slopes<T>& slopes_;
  const OrientedBox<T>& box_;
  T radius_;
  T margin_;
  std::optional<T> concavity_;
  Place<T> extent_;
  std::array<Vec3<T>, 3> axis_{};
  Interval<T> found_{};
};

}  // namespace

template <std::floating_point T>
Interval<T> leastIn(const Slopes<T>& slopes, const OrientedBox<T>& box, T atCenter,
                    std::optional<T> concavity) {
  return Descent<T>(slopes, box, concavity).run(atCenter);
}

template Interval<float> leastIn(const Slopes<float>&, const OrientedBox<float>&, float,
                                 std::optional<float>);
template Interval<double> leastIn(const Slopes<double>&, const OrientedBox<double>&, double,
                                  std::optional<double>);

}  // namespace cutwater::detail
