#pragma once

#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// Options of porosityRadius().
struct PorosityRadiusOptions {
  /// The search ends once the radius is known to within this fraction of the given range.
  double tolerance = 0.001;
  /// Limits on computing each solid's volume. `fraction` is the resolution in porosity: a radius
  /// whose porosity is as near to the target as that remains undecided.
  VolumeOptions volume = {.fraction = 1e-3, .isEstimated = false};
  /// Number of radii spread over the range whose porosities, to within 0.01, are compared to see
  /// whether the family is monotone; 0 if it is known to be.
  int samples = 8;
};

/// Result of porosityRadius().
template <std::floating_point T>
struct PorosityRadius {
  /// The porosities at its two ends certainly lie on either side of the target.
  Interval<T> radius;
  /// True unless two of the radii tried have porosities that are certainly in the opposite order to
  /// those at the ends of the range. If false, radii beyond the interval may give the same
  /// porosity.
  bool looksMonotone = true;
  int solids = 0;  ///< tried
};

/// Encloses the radius, or another parameter of a family of solids, at which the box has the given
/// porosity: the radius of a lattice's beams, for example. Certain if the volume within the box is
/// a continuous function of the radius; if it is also monotone, increasing or decreasing, there is
/// only one such radius. Works by bisection: each radius is certainly too small, certainly too
/// large, or undecided; bisection continues on both sides of the undecided ones.
/// @throws Error as solidVolume(), unless the range is finite and not empty and the tolerance
/// within (0, 1), and if the porosities at the ends of the range are not certainly on either side
/// of the target.
template <std::floating_point T>
[[nodiscard]] PorosityRadius<T> porosityRadius(double porosity,
                                               FunctionRef<Solid<T>(T radius)> solidOf,
                                               const Interval<T>& range, const Box<T>& box,
                                               const PorosityRadiusOptions& options = {});

extern template PorosityRadius<float> porosityRadius(double, FunctionRef<Solid<float>(float)>,
                                                     const Interval<float>&, const Box<float>&,
                                                     const PorosityRadiusOptions&);
extern template PorosityRadius<double> porosityRadius(double, FunctionRef<Solid<double>(double)>,
                                                      const Interval<double>&, const Box<double>&,
                                                      const PorosityRadiusOptions&);

}  // namespace cutwater
