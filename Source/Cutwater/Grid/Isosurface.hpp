#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater {

/// Options of isosurface().
struct IsosurfaceOptions {
  /// Points of the mesh are within this of the surface, in units of the largest spacing.
  double tolerance = 1e-3;
  /// Where gradients in a cell differ by more than this, in degrees, the solid has an edge or a
  /// corner, and the mesh gets it too, if it lies within that cell. 180 turns this off.
  double featureAngle = 180;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Triangulates the surface of the solid by marching cubes over the nodes of a grid patch, and
/// closes it where the grid patch ends. The result has no boundary: each edge has two triangles,
/// each point one fan, and normals point out of the solid. Works for every solid, even if only its
/// signs are known.
///
/// Points lie on edges between nodes of different sign, and the sign certainly changes within the
/// tolerance of each. Where the signs of a cell are ambiguous, the sign in the middle of its face
/// decides. Parts thinner than the spacing may be lost between nodes, and sharp edges are cut off,
/// by up to one spacing. Boxes of cells that classify() proves to be free of surface are not
/// evaluated, so the cost is about that of the cells near it.
///
/// With a `featureAngle` the mesh follows edges and corners, by means of closest points on the
/// solid.
///
/// The mesh has the solid's patches: each triangle has the patch of the surface at its middle.
/// Triangles that close the surface where the grid ends have one more, "end of grid". The mesh is
/// the same for any number of threads.
/// @throws Error unless the level is one of nodes, and there are two along each axis, the tolerance
/// is between 1e-9 and 0.5, and `threads` is not negative; of kind Limit beyond 2^32 - 2 points or
/// triangles, or 2^31 nodes along an axis.
template <std::floating_point T>
[[nodiscard]] PolygonSoup isosurface(const SignedDistanceFunction<T>& solid,
                                     const GridPatch<T>& nodes,
                                     const IsosurfaceOptions& options = {});

/// The nodes of a grid of cubic cells around a box, with a margin of at least one cell on each
/// side.
/// @throws Error unless the box is finite and not empty, the spacing is positive and finite, and
/// there are less than 2^31 nodes along each axis.
template <std::floating_point T>
[[nodiscard]] GridPatch<T> nodesAround(const Box<T>& box, T spacing);

extern template PolygonSoup isosurface(const SignedDistanceFunction<float>&,
                                       const GridPatch<float>&, const IsosurfaceOptions&);
extern template PolygonSoup isosurface(const SignedDistanceFunction<double>&,
                                       const GridPatch<double>&, const IsosurfaceOptions&);
extern template GridPatch<float> nodesAround(const Box<float>&, float);
extern template GridPatch<double> nodesAround(const Box<double>&, double);

}  // namespace cutwater
