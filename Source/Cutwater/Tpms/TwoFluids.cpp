#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

namespace cutwater {

template <std::floating_point T>
TpmsChannels<T> TpmsChannels<T>::of(const TpmsField<T>& field, const GradedValue<T>& level) {
  const TpmsSolid<T> wall(field, TpmsPart::Wall, level);  // throws for invalid levels
  return {TpmsSolid<T>(field, TpmsPart::ChannelA, level),
          TpmsSolid<T>(field, TpmsPart::ChannelB, level)};
}

template <std::floating_point T>
TpmsChannels<T> TpmsChannels<T>::of(const MetricWall<T>& wall) {
  Solid<T> half = TpmsSolid<T>(TpmsField<T>(wall.pattern(), wall.cellSize()), TpmsPart::ChannelA,
                               GradedValue<T>(0));
  half.setPlacement(wall.placement());
  const Solid<T> solid = wall;
  return {half - solid, ~half - solid};
}

template <std::floating_point T>
TwoFluids<T> twoFluids(const Solid<T>& domain, const TpmsChannels<T>& channels,
                       const std::vector<ClosedEnd<T>>& ends) {
  auto a = channels.a;
  auto b = channels.b;
  for (const auto& [region, channel] : ends) {
    auto& closed = channel == TpmsChannel::A ? a : b;
    closed = closed - region;
  }
  return {.a = domain & a, .wall = domain - a - b, .b = domain & b};
}

namespace {

/// Patches of the results of twoFluidsIn(), besides those of the channels.
constexpr auto kOutside = "outside";
constexpr auto kCaps = "caps";

/// All points beyond the place along the direction.
template <std::floating_point T>
Solid<T> beyond(int axis, T place, T direction) {
  Vec3<T> point;
  Vec3<T> inwards;
  point[axis] = place;
  inwards[axis] = -direction;
  return named(Plane<T>(point, inwards), kCaps);
}

}  // namespace

template <std::floating_point T>
TwoFluids<T> twoFluidsIn(const Box<T>& box, const TpmsChannels<T>& channels,
                         const CrossFlow<T>& flow) {
  const auto isAxis = [](int axis) { return axis >= 0 && axis < 3; };
  require(isAxis(flow.axisOfA) && isAxis(flow.axisOfB) && flow.axisOfA != flow.axisOfB,
          "twoFluidsIn: need two different axes of 0, 1 and 2", Named{"axisOfA", flow.axisOfA},
          Named{"axisOfB", flow.axisOfB});
  std::vector<ClosedEnd<T>> ends;
  for (int axis = 0; axis < 3; ++axis) {
    require(flow.capThickness > 0 && 2 * flow.capThickness < box.upper[axis] - box.lower[axis],
            "twoFluidsIn: need caps thinner than half the box",
            Named{"capThickness", flow.capThickness}, Named{"size", box.size()});
    for (const auto channel : {TpmsChannel::A, TpmsChannel::B}) {
      if (axis == (channel == TpmsChannel::A ? flow.axisOfA : flow.axisOfB)) continue;
      ends.push_back({beyond(axis, box.lower[axis] + flow.capThickness, T(-1)), channel});
      ends.push_back({beyond(axis, box.upper[axis] - flow.capThickness, T(1)), channel});
    }
  }
  return twoFluids<T>(named(Cuboid<T>(box.lower, box.upper), kOutside), channels, ends);
}

template <std::floating_point T>
TwoFluids<T> twoFluidsIn(const CylinderFlow<T>& cylinder, const TpmsChannels<T>& channels) {
  const auto& [radius, z, cap] = cylinder;
  require(cap > 0 && cap < radius && 2 * cap < z.upper - z.lower,
          "twoFluidsIn: need caps thinner than the radius and half the height",
          Named{"capThickness", cap}, Named{"radius", radius});
  const std::vector<ClosedEnd<T>> ends{
      {beyond(2, z.lower + cap, T(-1)), TpmsChannel::B},
      {beyond(2, z.upper - cap, T(1)), TpmsChannel::B},
      {named(~InfiniteCylinder<T>({0, 0, 0}, {0, 0, 1}, radius - cap), kCaps), TpmsChannel::A}};
  const Cylinder<T> whole({0, 0, z.lower}, {0, 0, z.upper}, radius);
  return twoFluids<T>(named(whole, kOutside), channels, ends);
}

template struct TpmsChannels<float>;
template TwoFluids<float> twoFluids(const Solid<float>&, const TpmsChannels<float>&,
                                    const std::vector<ClosedEnd<float>>&);
template TwoFluids<float> twoFluidsIn(const Box<float>&, const TpmsChannels<float>&,
                                      const CrossFlow<float>&);
template TwoFluids<float> twoFluidsIn(const CylinderFlow<float>&, const TpmsChannels<float>&);
template struct TpmsChannels<double>;
template TwoFluids<double> twoFluids(const Solid<double>&, const TpmsChannels<double>&,
                                     const std::vector<ClosedEnd<double>>&);
template TwoFluids<double> twoFluidsIn(const Box<double>&, const TpmsChannels<double>&,
                                       const CrossFlow<double>&);
template TwoFluids<double> twoFluidsIn(const CylinderFlow<double>&, const TpmsChannels<double>&);

}  // namespace cutwater
