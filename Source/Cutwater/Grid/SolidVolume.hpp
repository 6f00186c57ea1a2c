#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// When the search for a volume ends: as soon as one of the first three allows it.
struct VolumeOptions {
  /// The volume is known to within this fraction of the box's: the porosity to within this much.
  double fraction = 0.01;
  /// It is known to within this fraction of itself.
  double relative = 0;
  /// At most so many cells are classified. They take less than 30 bytes each.
  std::size_t cells = 10'000'000;
  /// Whether there is to be an estimate, for a value and a gradient in each undecided cell.
  bool isEstimated = true;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
};

/// What is known of the volume of a solid within a box.
struct VolumeBounds {
  /// Certainly encloses it.
  Interval<double> volume;
  /// A value within these bounds, and no more than that is certain: undecided cells are taken to be
  /// cut by a plane, as the value and gradient at their centre have it. Its error is about that of
  /// the planes, of second order in the cells' width where surfaces are smooth and gradients those
  /// of a distance. The middle of the bounds, if no estimate was asked for.
  double estimate = 0;
  double boxVolume = 0;
  std::size_t cells = 0;  ///< classified
  /// Known as closely as asked for; not if the limit of cells has ended the search.
  bool isWithinTolerance = false;

  /// Fraction of the box that is solid, and that is not: they certainly lie within.
  [[nodiscard]] Interval<double> solidFraction() const;
  [[nodiscard]] Interval<double> porosity() const;
};

/// Encloses the volume of the solid within the box, infinite ones too: the box is divided wherever
/// classify() decides nothing, the largest cells first, and cells that are certainly inside, or
/// outside, are counted. Nothing is sampled, so no thin part is missed; where all that is known of
/// a function is its sign, nothing is decided, either.
///
/// The bounds close in on the volume with the width of the cells that the surface meets: to halve
/// what is between takes about four times the cells. The same for any number of threads.
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
