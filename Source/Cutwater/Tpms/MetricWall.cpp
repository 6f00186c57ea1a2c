#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/Detail/Constants.hpp>
#include <Cutwater/Tpms/Detail/NumericalGradient.hpp>
#include <Cutwater/Tpms/Detail/PatternDistance.hpp>
#include <Cutwater/Tpms/MetricWall.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using detail::kTwoPi;

// In radians.
double toleranceWithin(const TpmsPattern& pattern, double reach) {
  return reach <= detail::PatternDistance::certainReach(pattern) ? 1e-9 : 1e-4 * kTwoPi<double>;
}

}  // namespace

template <std::floating_point T>
MetricWall<T>::MetricWall(TpmsPattern pattern, T cellSize, GradedValue<T> halfThickness)
    : pattern_(pattern),
      cellSize_(cellSize),
      halfThickness_(std::move(halfThickness)),
      reach_(1.5 * double{halfThickness_.most()} / double{cellSize} * kTwoPi<double>),
      tolerance_(toleranceWithin(pattern, reach_)),
      distance_(std::make_shared<const detail::PatternDistance>(pattern, tolerance_)) {
  require(cellSize > 0 && std::isfinite(cellSize) && std::isfinite(1 / cellSize),
          "MetricWall: need 0 < cellSize < infinity", Named{"cellSize", cellSize});
  require(halfThickness_.guarantee().domain == Box<T>::everywhere(),
          "MetricWall: need a thickness that is known everywhere");
  const double most =
      std::min(pattern.inscribedRadius(TpmsChannel::A), pattern.inscribedRadius(TpmsChannel::B)) *
      double{cellSize};
  require(
      halfThickness_.least() > 0 && double{halfThickness_.most()} < most,
      "MetricWall: need half a thickness between 0 and the radius of the largest ball in a channel",
      Named{"least", halfThickness_.least()}, Named{"most", halfThickness_.most()},
      Named{"radius", most});
  guarantee_ = {Quality::LowerBound, Quality::LowerBound, T(1), true};
  guarantee_.ulps = 8 + halfThickness_.guarantee().ulps;
  guarantee_.size = cellSize + halfThickness_.guarantee().size +
                    tolerance() / (guarantee_.ulps * std::numeric_limits<T>::epsilon());
}

template <std::floating_point T>
T MetricWall<T>::tolerance() const {
  return static_cast<T>(tolerance_ / kTwoPi<double> * double{cellSize_});
}

template <std::floating_point T>
T MetricWall<T>::localSignedDistance(const Vec3<T>& p) const {
  Vec3<double> place;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = double{p[axis]} / double{cellSize_};
    place[axis] = kTwoPi<double> * (cells - std::floor(cells));
  }
  const double distance = distance_->upTo(reach_, place) / kTwoPi<double> * double{cellSize_};
  const double half{halfThickness_.at(p)};
  return static_cast<T>((distance - half) / (1 + double{halfThickness_.lipschitz()}));
}

template <std::floating_point T>
Vec3<T> MetricWall<T>::localGradient(const Vec3<T>& p) const {
  const auto value = [this](const Vec3<T>& q) { return localSignedDistance(q); };
  return detail::numericalGradient(value, p, cellSize_);
}

template <std::floating_point T>
std::string MetricWall<T>::localName() const {
  return "Wall of even thickness of a " + pattern_.name();
}

template class MetricWall<float>;
template class MetricWall<double>;

}  // namespace cutwater
