#pragma once

#include <Cutwater/Triangles/QueryBox.hpp>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

namespace cutwater {

/// A box in the form that the vector code reads, in the tree's frame; see BoxSearch.inl.
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
  /// How much farther apart a triangle must be for QueryBox, in double precision, to find it apart,
  /// too; and how much deeper in the box for QueryBox to find that they meet.
  float rounding = 0;
  float depth = 0;
  /// How far boxes within this one may reach beyond it after rounding.
  float reach = 0;
};

/// The most certain of the results of QueryBox::overlapWith() for this triangle and those before
/// it, as the vector code calls it.
struct ExactOverlap {
  BoxOverlap (*function)(void* context, std::uint32_t triangle);
  void* context;
};

/// Whether the box meets triangles of the surface, in the surface's units: the most certain of the
/// results of QueryBox::overlapWith() for these triangles.
///
/// `node` is one below which all triangles lie that the box can meet, at first the root, number 0.
/// It is updated for queries with boxes within this one.
template <std::floating_point T>
[[nodiscard]] BoxOverlap overlapOf(const TriangleSearch& tree, const TriangleSurface<T>& surface,
                                   const OrientedBox<double>& box, std::uint32_t& node);

}  // namespace cutwater
