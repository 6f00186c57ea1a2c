#pragma once

#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <array>
#include <concepts>
#include <memory>
#include <vector>

namespace cutwater {

class SingleValuedParts;

/// Whether all of a box within cut cells is fluid or body; Cut for all others, though no cell may
/// be.
[[nodiscard]] FluidClass classOf(const CutCells& cells, const IndexBox& box);

/// Where the fields of a box of cells are written: of its cells, and of the faces, edges and nodes
/// between them and around the box. Each view begins at the box's lowest index.
///
/// Lengths are in widths of cells, areas of faces in their own, and centroids are offsets from the
/// middle of the cell, the face or the edge. What lies in the body has centroids of 0.
template <std::floating_point T>
struct SingleValuedFields {
  GridView<FluidClass> kind;  ///< Fluid: regular; Body: covered; Cut
  GridView<T> volumeFraction;
  std::array<GridView<T>, 3> centroid;
  /// The length of the sum of a cell's open parts, so that times the normal it closes them; with
  /// unequal widths it is the area of a plane with this normal, in that of the cell's section.
  GridView<T> wallArea;
  std::array<GridView<T>, 3> wallCentroid;  ///< -1 where there is no wall
  std::array<GridView<T>, 3> wallNormal;    ///< unit, out of the fluid
  std::array<GridView<T>, 3> aperture;      ///< of the faces across each axis
  /// Of the faces across each axis: along the other two, in ascending order.
  std::array<std::array<GridView<T>, 2>, 3> faceCentroid;
  /// Of the edges along each axis: 1 where all is fluid, -1 where nothing is.
  std::array<GridView<T>, 3> edgeCentroid;
  GridView<T> levelSet;  ///< of nodes: -1 in the fluid, 0 on closed faces, 1 in the body
};

/// Options of SingleValuedCells.
struct SingleValuedOptions {
  /// Cells with a smaller share of fluid are covered: see MergeOptions.
  double smallest = 1e-14;
  /// Whether the cells are those of CellCutter::cutInPlane(): one layer, of which the fields of a
  /// code in 2D are filled. Faces are those across x and y; so are edges, those along the other of
  /// both. Nodes are those of the layer's lower side.
  bool isPlane = false;
  /// See ParallelOptions.
  int threads = 0;
};

/// One level of cut cells for codes that hold one piece of fluid a cell, and one wall, such as
/// AMReX's EB2: what merged() keeps, as fields over boxes of indices.
///
/// Beyond the box, along axes without a period, the solid goes on as it is in the box's faces: an
/// open part of a face is that of all cells behind it, and an edge or a corner of the box likewise.
/// The centroid of the wall of such a cell is that of a plane with its normal: the mean of the wall
/// with the weight of the normal's component, by the divergence theorem.
///
/// Copies share everything. All functions are const and thread-safe.
class SingleValuedCells {
 public:
  /// The finest level.
  /// @param cells  those of a box, or of all cells of a period along axes that have one; with
  /// polygons, for the open parts of edges, unless they lie in a plane.
  /// @param options  see there.
  /// @throws Error(Argument) for cells without polygons, for a period that the box does not span,
  /// and unless options are within their ranges.
  explicit SingleValuedCells(const CutCells& cells, const SingleValuedOptions& options = {});

  /// The level of cells that each join two along each axis, in a plane along x and y, made by
  /// coarsened() of what is kept here. @throws Error(Argument) unless canCoarsen().
  [[nodiscard]] SingleValuedCells coarser() const;
  /// Whether the box has an even number of cells along each of these axes, and begins at one.
  [[nodiscard]] bool canCoarsen() const;

  /// What is kept; none of it lies beyond the box.
  [[nodiscard]] const CutCells& cells() const;
  /// What was covered on this level, sorted as rows are.
  [[nodiscard]] const std::vector<LostPiece>& lost() const;
  /// Of the cells that have a wall, the share of those whose wall is nothing but faces to what was
  /// covered on this level: where they lie, finer levels have none.
  [[nodiscard]] double newWallShare() const;

  /// Of a box within this one: classOf().
  [[nodiscard]] FluidClass classify(const IndexBox& box) const { return classOf(cells(), box); }

  /// Sets all fields of a box, which may reach beyond the cells. Values of one index are the same
  /// bits whatever the box.
  template <std::floating_point T>
  void fill(const IndexBox& box, const SingleValuedFields<T>& fields) const;

 private:
  explicit SingleValuedCells(std::shared_ptr<const SingleValuedParts> parts);

  std::shared_ptr<const SingleValuedParts> parts_;
};

extern template void SingleValuedCells::fill(const IndexBox&,
                                             const SingleValuedFields<float>&) const;
extern template void SingleValuedCells::fill(const IndexBox&,
                                             const SingleValuedFields<double>&) const;

}  // namespace cutwater
