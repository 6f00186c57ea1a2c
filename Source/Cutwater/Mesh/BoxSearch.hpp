#pragma once

#include <Cutwater/Mesh/QueryBox.hpp>
#include <Cutwater/Mesh/TriangleSearch.hpp>

namespace cutwater {

/// A box as the vector code reads it, in the tree's frame; see BoxSearch.inl.
struct TreeBox {
  TreeBox(const QueryBox& box, const BvhFrame& frame);

  Vec3<double> center;
  Vec3<float> axes[3];
  Vec3<float> half;         ///< lengths along the axes
  Vec3<float> halfAxes[3];  ///< the axes times these
  float size = 0;           ///< sum of the half lengths
  float leastHalf = 0;
  bool isAligned = false;  ///< the axes are those of the frame
  /// How much farther apart, in double precision, a triangle is to be that QueryBox finds apart,
  /// and how much deeper in one that it finds to meet the box.
  float rounding = 0;
  float depth = 0;
};

/// Whether the box meets triangles of the surface, in the surface's units: what
/// QueryBox::overlapWith() tells about each of them, the most certain of it.
template <std::floating_point T>
[[nodiscard]] BoxOverlap overlapOf(const TriangleSearch& tree, const TriangleSurface<T>& surface,
                                   const OrientedBox<double>& box);

}  // namespace cutwater
