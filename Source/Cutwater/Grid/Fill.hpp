#pragma once

#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// Options of fill().
struct FillOptions {
  /// Half-width of the band around the surface in which values are computed, in cells of the
  /// smallest spacing h. Beyond it they are exactly +band * h or -band * h. 0: values everywhere.
  double band = 0;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// The arrays that one pass over a grid patch fills; those without data are skipped. They must not
/// overlap.
template <std::floating_point T>
struct FillTargets {
  GridView<T> distance = {};  ///< signedDistance() at the index's position, to the bit
  /// The surface's patch at the closest surface point, see patchNames(); kNone beyond the band.
  GridView<std::uint32_t> patch = {};
  /// The closest surface point, and the outward unit normal there, as closestPoint() gives them;
  /// NaN beyond the band.
  GridView<Vec3<T>> closestPoint = {};
  GridView<Vec3<T>> normal = {};
  /// The class of the closed box level.cell(index): of the cell, or of the control volume around
  /// the node, whose middle is the index's position. Everywhere, whatever the band.
  GridView<BoxClass> boxClass = {};
};

/// Evaluates the solid at every index of the grid patch: at cell centres or nodes, depending on its
/// level. A value within the band has the bits that signedDistance() gives at that position: they
/// do not depend on the grid patch, the band or the number of threads. Serial inside an active
/// parallel region.
///
/// With a band, the cost is about two evaluations for each index in it: boxes of indices are
/// skipped where the solid's Lipschitz constant, or without one its bounds(), proves that they are
/// beyond it, and a closed mesh finds the points in it by itself. A class is what classify() says
/// about the cell, on any grid patch; it costs about as much as the distances in a band of one
/// cell, and a box query for the cells whose centre does not tell, or for all if there is no
/// Lipschitz constant.
/// @throws Error if the band is negative or not finite, or `threads` is negative.
template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
          const FillTargets<T>& targets, const FillOptions& options = {});

/// Fills the distance only.
template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
          const GridView<T>& distance, const FillOptions& options = {}) {
  fill(solid, gridPatch, FillTargets<T>{.distance = distance}, options);
}

extern template void fill(const SignedDistanceFunction<float>&, const GridPatch<float>&,
                          const FillTargets<float>&, const FillOptions&);
extern template void fill(const SignedDistanceFunction<double>&, const GridPatch<double>&,
                          const FillTargets<double>&, const FillOptions&);

}  // namespace cutwater
