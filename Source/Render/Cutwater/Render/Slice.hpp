#pragma once

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Render/Image.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <array>
#include <optional>
#include <string>

namespace cutwater {

struct CutCells;
struct CutLeaves;

/// A plane with coordinates (a, b) on it: the points origin + a right + b up.
template <std::floating_point T>
struct SlicePlane {
  Vec3<T> origin;
  Vec3<T> right;  ///< unit
  Vec3<T> up;     ///< unit, at a right angle to `right`
  std::array<std::string, 2> labels{"a", "b"};

  /// The plane where the coordinate `axis` (0, 1 or 2) has this value, with the two other
  /// coordinates on it: (y, z), (x, z) or (x, y).
  /// @throws Error unless the axis is 0, 1 or 2 and the value finite.
  static SlicePlane across(int axis, T value);
  /// Through a point, along two directions of any length; `up` is made normal to `right`.
  /// @throws Error unless all are finite and the directions span a plane.
  static SlicePlane through(const Vec3<T>& point, const Vec3<T>& right, const Vec3<T>& up);
};

/// A rectangle in a plane's own coordinates.
template <std::floating_point T>
struct SliceWindow {
  std::array<T, 2> lower;
  std::array<T, 2> upper;
};

/// Options of renderSlice().
template <std::floating_point T>
struct SliceOptions {
  /// The part that is shown, in full and to scale. Without it: all of the mesh, or else the solid's
  /// bounding box with some margin.
  std::optional<SliceWindow<T>> window = {};
  int width = 1600;   ///< of the picture, pixels
  int height = 1000;  ///< of the picture, pixels
  std::string title = {};
  std::string unit = {};  ///< of lengths, e.g. "m"
  T isolineSpacing = 0;   ///< distance between iso-distance lines; 0: a suitable round number
  /// Mesh whose cells are outlined where the plane cuts them; or null.
  const Octree<T>* mesh = nullptr;
  int threads = 0;  ///< see ParallelOptions
  Progress progress = {};
};

/// Renders a picture of the signed distance in a plane: colours, lines of equal distance, the
/// outline of the solid, axes and a colour bar. Takes one query per pixel; the outline is smooth
/// because the distance determines how much of a pixel it covers.
/// @throws Error if the picture is smaller than 320 x 240 pixels or larger than Image allows, a
/// window is empty or not finite, or the solid is unbounded and no window is given.
template <std::floating_point T>
[[nodiscard]] Image renderSlice(const SignedDistanceFunction<T>& solid, const SlicePlane<T>& plane,
                                const SliceOptions<T>& options = {});

/// Options of renderCells().
struct CellSliceOptions {
  /// The part that is shown, as in SliceOptions. Without it: all cells of the layer.
  std::optional<SliceWindow<double>> window = {};
  int width = 1600;   ///< of the picture, pixels
  int height = 1000;  ///< of the picture, pixels
  std::string title = {};
  std::string unit = {};  ///< of lengths, e.g. "m"
};

/// Renders a picture of one layer of cut cells, in the plane through its middle: each piece of
/// fluid in the colour of its share of the cell, the body hatched, the wall as a line. The body's
/// part of a cut cell is tinted with the colour of the fluid beside it, so small cells stay in
/// sight. Cells with several pieces are framed, and those with all corners on one side have a dot.
///
/// The layer lies across an axis, 0, 1 or 2, and is told by the index of its cells along it. The
/// plane's coordinates are those of SlicePlane::across().
/// @throws Error(Argument) unless the box has such cells and they were cut with their polygons (see
/// CutOptions); and as renderSlice() does.
[[nodiscard]] Image renderCells(const CutCells& cells, int axis, std::int32_t layer,
                                const CellSliceOptions& options = {});

/// The same of the leaves of an octree that a plane meets, at their sizes: that across an axis, at
/// this place on it. Where it lies between leaves, those above it are shown. `mesh`: the octree, or
/// the part of one, whose leaves were cut. With one level, and in the middle of a layer, it is the
/// picture of the grid's.
/// @throws Error(Argument) unless there are leaves in the plane, of this octree, which were cut
/// with their polygons; and as renderSlice() does.
template <std::floating_point T>
[[nodiscard]] Image renderCells(const CutLeaves& leaves, const OctreeCells<T>& mesh, int axis,
                                double at, const CellSliceOptions& options = {});

extern template struct SlicePlane<float>;
extern template struct SlicePlane<double>;
extern template Image renderSlice(const SignedDistanceFunction<float>&, const SlicePlane<float>&,
                                  const SliceOptions<float>&);
extern template Image renderSlice(const SignedDistanceFunction<double>&, const SlicePlane<double>&,
                                  const SliceOptions<double>&);
extern template Image renderCells(const CutLeaves&, const OctreeCells<float>&, int, double,
                                  const CellSliceOptions&);
extern template Image renderCells(const CutLeaves&, const OctreeCells<double>&, int, double,
                                  const CellSliceOptions&);

}  // namespace cutwater
