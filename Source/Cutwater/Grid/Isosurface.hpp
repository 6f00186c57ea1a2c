#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// Options of isosurface().
struct IsosurfaceOptions {
  /// Points of the mesh are within this of the surface, in units of the largest spacing.
  double tolerance = 1e-3;
  /// Where gradients in a cell differ by more than this, in degrees, the solid has an edge or a
  /// corner, and the mesh gets one, too, if it lies within that cell. 180: none.
  double featureAngle = 180;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// The surface of the solid as triangles, by marching cubes over the nodes of a patch, closed where
/// it ends: a surface without boundary, each edge with two triangles and each point with one fan,
/// whose normals look out of the solid. Every solid will do, also if only its signs are known.
///
/// Points lie on edges between nodes of different sign, on either side of which the sign certainly
/// changes within the tolerance; where a cell alone does not tell what belongs together, the sign
/// in the middle of its face does. What is thinner than the spacing may be lost between nodes, and
/// edges of the solid are cut off by as much. Blocks of cells that classify() proves to be free of
/// surface are not evaluated, so the price is about that of the cells near it.
///
/// With a `featureAngle` the mesh follows edges and corners, by points that are the solid's own
/// closest points.
///
/// Patches are the solid's, by the owner of each triangle's middle; one more, "end of grid", for
/// what closes the surface there. The same mesh for any number of threads.
/// @throws Error unless the patch's level is one of nodes, and there are two along each axis, the
/// tolerance is between 1e-9 and 0.5, and `threads` is not negative; of kind Limit beyond 2^32 - 2
/// points or triangles, or 2^31 nodes along an axis.
template <std::floating_point T>
[[nodiscard]] PolygonSoup isosurface(const SignedDistanceFunction<T>& solid, const Patch<T>& nodes,
                                     const IsosurfaceOptions& options = {});

/// The nodes of a grid of cubes around a box, with at least one cell more on each side.
/// @throws Error unless the box is finite and not empty, the spacing is positive and finite, and
/// there are less than 2^31 nodes along each axis.
template <std::floating_point T>
[[nodiscard]] Patch<T> nodesAround(const Box<T>& box, T spacing);

extern template PolygonSoup isosurface(const SignedDistanceFunction<float>&, const Patch<float>&,
                                       const IsosurfaceOptions&);
extern template PolygonSoup isosurface(const SignedDistanceFunction<double>&, const Patch<double>&,
                                       const IsosurfaceOptions&);
extern template Patch<float> nodesAround(const Box<float>&, float);
extern template Patch<double> nodesAround(const Box<double>&, double);

}  // namespace cutwater
