#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

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
  /// An estimate within these bounds; nothing else about it is certain. Undecided cells are taken
  /// to be cut by the plane that the value and gradient at their centre define. Its error is about
  /// that of the planes: second order in the cells' width where surfaces are smooth and gradients
  /// are those of a distance. Without `isEstimated`, the middle of the bounds.
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

}  // namespace cutwater
