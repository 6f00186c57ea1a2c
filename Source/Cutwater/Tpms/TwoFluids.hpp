#pragma once

#include <Cutwater/Tpms/MetricWall.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <vector>

namespace cutwater {

/// The two endless channels on either side of a wall.
template <std::floating_point T>
struct TpmsChannels {
  Solid<T> a;
  Solid<T> b;

  /// The channels beside a wall |F| <= h. @throws Error as TpmsSolid does for that wall.
  [[nodiscard]] static TpmsChannels of(const TpmsField<T>& field, const GradedValue<T>& level);
  /// The channels beside a wall of even thickness.
  [[nodiscard]] static TpmsChannels of(const MetricWall<T>& wall);
};

/// A region in which a channel is closed, i.e. filled with solid.
template <std::floating_point T>
struct ClosedEnd {
  Solid<T> region;
  TpmsChannel channel;
};

/// A domain in three parts: the fluids in both channels, and the solid between them. Every point of
/// the domain is inside exactly one of them, or has the value 0 in two: their values and the
/// classes of boxes follow from the same numbers.
template <std::floating_point T>
struct TwoFluids {
  Solid<T> a;
  Solid<T> wall;
  Solid<T> b;
};

/// The three parts of any domain, with the channels closed as stated in `ends`.
template <std::floating_point T>
[[nodiscard]] TwoFluids<T> twoFluids(const Solid<T>& domain, const TpmsChannels<T>& channels,
                                     const std::vector<ClosedEnd<T>>& ends = {});

/// The flow through a heat exchanger in a box.
template <std::floating_point T>
struct CrossFlow {
  /// A flows along this axis: at its ends the box is open for A, and closed for B.
  int axisOfA = 0;
  /// B flows along this one, and A is closed off at its ends. The sides of the third axis are
  /// closed for both.
  int axisOfB = 1;
  /// Thickness of the caps that close the channels.
  T capThickness;
};

/// The sides of the box are the patch "outside"; on a fluid, these are its inlet and outlet. The
/// caps that close the channels are the patch "caps".
///
/// @throws Error unless the axes are two different ones of 0, 1 and 2, and caps are thinner than
/// half the box.
template <std::floating_point T>
[[nodiscard]] TwoFluids<T> twoFluidsIn(const Box<T>& box, const TpmsChannels<T>& channels,
                                       const CrossFlow<T>& flow);

/// A cylinder about the z axis as a heat exchanger: A flows from end to end, B through the lateral
/// surface.
template <std::floating_point T>
struct CylinderFlow {
  T radius;
  Interval<T> z;
  /// Thickness of the caps that close the ends for B, and the lateral surface for A.
  T capThickness;
};

/// Patches are as for a box.
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
