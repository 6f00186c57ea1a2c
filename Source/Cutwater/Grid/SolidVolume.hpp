#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// When the search for a volume ends: as soon as one of the first three criteria is met.
struct VolumeOptions {
  /// The volume is known to within this fraction of the box's, and so the porosity to within this
  /// number.
  double fraction = 0.01;
  /// The volume is known to within this fraction of itself.
  double relative = 0;
  /// At most this many cells are classified. They take less than 30 bytes each.
  std::size_t cells = 10'000'000;
  /// Whether to compute an estimate, at the cost of a value and a gradient in each undecided cell.
  bool isEstimated = true;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
};

/// Bounds on the volume of a solid within a box.
struct VolumeBounds {
  /// Certainly encloses the volume.
  Interval<double> volume;
  /// An estimate within these bounds; nothing else about it is certain. It assumes that undecided
  /// cells are cut by the plane that the value and gradient at their centre define; its error is of
  /// second order in the cells' width where surfaces are smooth and gradients are those of a
  /// distance. Without `isEstimated`, the middle of the bounds.
  double estimate = 0;
  double boxVolume = 0;
  std::size_t cells = 0;  ///< classified
  /// Whether the requested accuracy was reached; false if the limit on cells ended the search.
  bool isWithinTolerance = false;

  /// Bounds that certainly enclose the fraction of the box that is solid, and the one that is not.
  [[nodiscard]] Interval<double> solidFraction() const;
  [[nodiscard]] Interval<double> porosity() const;
};

/// Encloses the volume of the solid, which may be infinite, within the box. Divides the box
/// wherever classify() is undecided, the largest cells first, and adds up cells that are certainly
/// inside or certainly outside. Nothing is sampled, so no thin part is missed; but nothing can be
/// decided for a function of which only the sign is known.
///
/// The gap between the bounds shrinks with the width of the cells that the surface meets: halving
/// it takes about four times as many cells. The result is the same for any number of threads.
/// @throws Error unless the box is finite and its sides from 10^-80 to 10^80, `fraction` and
/// `relative` are not negative, `cells` is positive and `threads` is not negative.
template <std::floating_point T>
[[nodiscard]] VolumeBounds solidVolume(const SignedDistanceFunction<T>& solid, const Box<T>& box,
                                       const VolumeOptions& options = {});

extern template VolumeBounds solidVolume(const SignedDistanceFunction<float>&, const Box<float>&,
                                         const VolumeOptions&);
extern template VolumeBounds solidVolume(const SignedDistanceFunction<double>&, const Box<double>&,
                                         const VolumeOptions&);

/// Options of porosityRadius().
struct PorosityRadiusOptions {
  /// The search ends once the radius is known to within this fraction of the given range.
  double tolerance = 0.001;
  /// Limits on computing each solid's volume. `fraction` is the resolution in porosity: a radius
  /// whose porosity differs from the target by less than this remains undecided.
  VolumeOptions volume = {.fraction = 1e-3, .isEstimated = false};
  /// Number of radii spread over the range whose porosities, to within 0.01, are compared to see
  /// whether the family is monotone; 0 if it is known to be.
  int samples = 8;
};

/// Result of porosityRadius().
template <std::floating_point T>
struct PorosityRadius {
  /// The porosities at its two ends certainly lie on opposite sides of the target.
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
/// within (0, 1), and if the porosities at the ends of the range do not certainly lie on opposite
/// sides of the target.
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
