#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/CutCells/Detail/Curved/SolidImages.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Operations/Algebra.hpp>

#include <cmath>
#include <limits>

namespace cutwater {

namespace {

template <std::floating_point T>
BodySize sizeOf(const Solid<T>& solid) {
  const auto box = solid.boundingBox();
  return {{Vec3<double>(box.lower), Vec3<double>(box.upper)}};
}

/// Where to look at a solid along an axis: in a period, in its box, or anywhere.
Interval<double> sampledAlong(const BodySize& body, const CutPeriod& period, int axis) {
  if (period.isOn(axis)) return {period.start[axis], period.start[axis] + period.length[axis]};
  const auto& [lower, upper] = body.box;
  const double most = maxComponent(period.length);
  const double from = std::isfinite(lower[axis]) ? lower[axis] : -most;
  return {from, std::isfinite(upper[axis]) ? upper[axis] : from + 2 * most};
}

template <std::floating_point T>
void checkRepeats(const Solid<T>& solid, const CutPeriod& period, int axis) {
  constexpr std::size_t kSamples = 100;
  const auto body = sizeOf(solid);
  const double length = period.length[axis];
  const double rounding = std::sqrt(std::numeric_limits<T>::epsilon());
  for (std::size_t n = 0; n < kSamples; ++n) {
    auto point = evenlySpread(n);
    for (int a = 0; a < 3; ++a) {
      const auto [from, to] = sampledAlong(body, period, a);
      point[a] = from + point[a] * (to - from);
    }
    const auto value = double{solid.signedDistance(Vec3<T>(point))};
    point[axis] += length;
    const auto next = double{solid.signedDistance(Vec3<T>(point))};
    require(std::abs(value - next) <= rounding * (std::abs(value) + length),
            "cut cells: need a solid that has bounds, or that is the same a period further, along "
            "axes with a period",
            Named{"axis", axis}, Named{"period", length});
  }
}

}  // namespace

template <std::floating_point T>
CutPeriod periodOf(const Solid<T>& solid, const Vec3<double>& length) {
  const auto body = sizeOf(solid);
  auto period = periodOf(body.box, length);
  period.startBeside(body);
  for (int axis = 0; axis < 3; ++axis) {
    if (period.isOn(axis) && !body.isBounded(axis)) checkRepeats(solid, period, axis);
  }
  return period;
}

template <std::floating_point T>
Solid<T> withImages(const Solid<T>& solid, const CutPeriod& period) {
  if (!period.isOnAny()) return solid;
  std::vector<Solid<T>> images;
  for (const auto& shift : period.imagesOf(sizeOf(solid))) {
    images.push_back(translated(solid, Vec3<T>(shift)));
  }
  return unionOf(images);
}

template CutPeriod periodOf(const Solid<float>&, const Vec3<double>&);
template CutPeriod periodOf(const Solid<double>&, const Vec3<double>&);
template Solid<float> withImages(const Solid<float>&, const CutPeriod&);
template Solid<double> withImages(const Solid<double>&, const CutPeriod&);

}  // namespace cutwater
