#pragma once

#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// Options of porosityRadius().
struct PorosityRadiusOptions {
  /// Ends once the radius is known to within this fraction of the range that was given.
  double tolerance = 0.001;
  /// What each solid's volume takes at most. `fraction` is how closely porosities are told apart:
  /// where one is as near to the wanted one as that, nothing is decided about its radius.
  VolumeOptions volume = {.fraction = 1e-3, .isEstimated = false};
  /// Radii all over the range whose porosities are compared, to within 0.01, to see whether the
  /// family is monotone; none if that is known.
  int samples = 8;
};

/// What is known of the radius that gives a porosity.
template <std::floating_point T>
struct PorosityRadius {
  /// The porosities at both ends certainly lie on the two sides of the wanted one.
  Interval<T> radius;
  /// Porosities of no two radii that were tried are certainly in the other order than those at the
  /// ends of the range. If some are, radii beyond the interval may give the same porosity.
  bool looksMonotone = true;
  int solids = 0;  ///< tried
};

/// Encloses the radius, or another number that a family of solids depends on, with which the box
/// has this porosity: that of some beams of a lattice, say. Certain for families whose volume
/// within the box is a continuous function of the radius, and there is but one such radius if it is
/// monotone, growing or not. By bisection: each radius is certainly too small, too large, or not
/// decided; the bisection then goes on on both sides of those that are not.
/// @throws Error as solidVolume(), unless the range is finite and not empty and the tolerance
/// within (0, 1), and if porosities at the ends of the range are not certainly on two sides of the
/// wanted.
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
