#pragma once

#include <Cutwater/Mesh/QueryBox.hpp>
#include <Cutwater/Mesh/TriangleSearch.hpp>

namespace cutwater {

/// A box as the vector code reads it, in the tree's frame; see BoxSearch.inl.
struct TreeBox {
  TreeBox(const OrientedBox<double>& box, const BvhFrame& frame);

  /// In the tree's frame.
  Vec3<double> center;
  Vec3<float> half;        ///< lengths along the axes, slack included
  float size = 0;          ///< sum of the half lengths
  float leastHalf = 0;     ///< the least of them
  bool isAligned = false;  ///< the axes are those of the frame, and not stored
  Vec3<float> axes[3];
  Vec3<float> halfAxes[3];  ///< the axes times the half lengths
  /// How much farther apart, in double precision, a triangle is to be that QueryBox finds apart,
  /// and how much deeper in one that it finds to meet the box.
  float rounding = 0;
  float depth = 0;
  /// How far boxes within this one, once rounded, may reach beyond it.
  float reach = 0;
};

/// QueryBox::overlapWith() for a triangle, as the vector code calls it.
struct ExactOverlap {
  BoxOverlap (*function)(void* context, std::uint32_t triangle);
  void* context;
};

/// Whether the box meets triangles of the surface, in the surface's units: what
/// QueryBox::overlapWith() tells about each of them, the most certain of it.
///
/// All triangles that boxes within this one meet are below a node of the tree: the root, number 0,
/// or what `node` is then.
template <std::floating_point T>
[[nodiscard]] BoxOverlap overlapOf(const TriangleSearch& tree, const TriangleSurface<T>& surface,
                                   const OrientedBox<double>& box, std::uint32_t& node);

}  // namespace cutwater
