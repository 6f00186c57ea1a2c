#pragma once

#include <Cutwater/Tpms/MetricWall.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <vector>

namespace cutwater {

/// The two channels on either side of a wall, endless.
template <std::floating_point T>
struct TpmsChannels {
  Solid<T> a;
  Solid<T> b;

  /// Beside a wall |F| <= h. @throws Error as TpmsSolid does for that wall.
  [[nodiscard]] static TpmsChannels of(const TpmsField<T>& field, const GradedValue<T>& level);
  /// Beside a wall of even thickness.
  [[nodiscard]] static TpmsChannels of(const MetricWall<T>& wall);
};

/// Where a channel is closed: solid fills it there.
template <std::floating_point T>
struct ClosedEnd {
  Solid<T> region;
  TpmsChannel channel;
};

/// A domain in three parts: the fluids in both channels, and the solid between. Every point of the
/// domain is inside of one of them alone, or has the value 0 in two: they share their decisions to
/// the bit, and so do their boxes.
template <std::floating_point T>
struct TwoFluids {
  Solid<T> a;
  Solid<T> wall;
  Solid<T> b;
};

/// Of any domain, with the channels closed where `ends` say.
template <std::floating_point T>
[[nodiscard]] TwoFluids<T> twoFluids(const Solid<T>& domain, const TpmsChannels<T>& channels,
                                     const std::vector<ClosedEnd<T>>& ends = {});

/// How a heat exchanger in a box is passed through.
template <std::floating_point T>
struct CrossFlow {
  /// A flows along this axis: at its ends the box is open for A, and closed for B.
  int axisOfA = 0;
  /// B flows along this one, and A is closed off at its ends. The sides of the third axis are
  /// closed for both.
  int axisOfB = 1;
  /// Of what closes them.
  T capThickness;
};

/// The sides of the box are the patch "outside", of a fluid where it comes in and goes out; what
/// closes the channels is "caps".
///
/// @throws Error unless the axes are two of 0, 1 and 2, and caps are thinner than half the box.
template <std::floating_point T>
[[nodiscard]] TwoFluids<T> twoFluidsIn(const Box<T>& box, const TpmsChannels<T>& channels,
                                       const CrossFlow<T>& flow);

/// A cylinder about the z axis as a heat exchanger: A passes from end to end, B through its mantle.
template <std::floating_point T>
struct CylinderFlow {
  T radius;
  Interval<T> z;
  /// Of what closes the ends for B, and the mantle for A.
  T capThickness;
};

/// Patches as in a box.
///
/// @throws Error unless caps are thinner than the radius and half the height.
template <std::floating_point T>
[[nodiscard]] TwoFluids<T> twoFluidsIn(const CylinderFlow<T>& cylinder,
                                       const TpmsChannels<T>& channels);

extern template struct TpmsChannels<float>;
extern template TwoFluids<float> twoFluids(const Solid<float>&, const TpmsChannels<float>&,
                                           const std::vector<ClosedEnd<float>>&);
extern template TwoFluids<float> twoFluidsIn(const Box<float>&, const TpmsChannels<float>&,
                                             const CrossFlow<float>&);
extern template TwoFluids<float> twoFluidsIn(const CylinderFlow<float>&,
                                             const TpmsChannels<float>&);
extern template struct TpmsChannels<double>;
extern template TwoFluids<double> twoFluids(const Solid<double>&, const TpmsChannels<double>&,
                                            const std::vector<ClosedEnd<double>>&);
extern template TwoFluids<double> twoFluidsIn(const Box<double>&, const TpmsChannels<double>&,
                                              const CrossFlow<double>&);
extern template TwoFluids<double> twoFluidsIn(const CylinderFlow<double>&,
                                              const TpmsChannels<double>&);

}  // namespace cutwater
