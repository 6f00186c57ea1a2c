#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <memory>
#include <string>
#include <vector>

namespace cutwater {

class CapAngles;
class CutSurface;
class FluidField;
struct CutPeriod;

/// Options of CellCutter::cut().
struct CutOptions {
  /// Whether to keep the polygons of arcs and walls. They take some four times the memory of the
  /// other rows.
  bool polygons = false;
  /// The highest degree of the moments of volumes, walls and arcs, from 0 to 4: see
  /// CutCells::Moments. -1: none.
  int moments = -1;
  /// Whether to keep points and weights to integrate functions by: see CutCells::Quadrature.
  bool quadrature = false;
  /// Up to this degree, from 0 to 4, the points of a CellCutter integrate polynomials exactly, but
  /// for rounding. Those of a SolidCutter are of SolidCutterOptions::points.
  int quadratureDegree = 4;
  /// See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Options of a CellCutter.
struct CutterOptions {
  /// Whether to close the holes of an open surface, by triangles across their rims, in a patch of
  /// their own named "cap", the last one. If false, open surfaces are refused.
  bool capHoles = false;
  /// The names of patches that are no walls but open, such as inlets, outlets and planes of
  /// symmetry. They must lie in planes of the grid: what they have of a face is an arc that leads
  /// to CutCells::kBeyond, and the fluid goes on there. See Docs/cut-cells.md.
  std::vector<std::string> openPatches = {};
  /// The names of patches that are baffles: sheets without thickness, open or closed, with fluid
  /// and a wall on both sides. They may end anywhere, and meet and cross each other and walls; in
  /// the body they are nothing. What is left without them must be closed, if there is any. See
  /// Docs/cut-cells.md.
  std::vector<std::string> baffles = {};
  /// The period of the body along each axis, 0: none. The body is the solid with all its images
  /// whole periods away; where a solid goes on through its images, ends that are alike cancel each
  /// other. Vertices and the period are rounded to multiples of a power of two, about 1e-15 of the
  /// largest coordinate or period. See Docs/cut-cells.md.
  Vec3<double> period = {};
};

/// Cuts the cells of grids by a closed surface: the body is where its winding number is positive,
/// so shells form a union. Cells are cut exactly: on which side of planes, of lines and of nodes of
/// the grid the surface passes is decided by exact predicates, and only the points where it does
/// are rounded. So the number of pieces, and what connects them, is right however thin walls and
/// gaps are, and pieces close up to rounding. Where triangles meet others outside of corners and
/// edges that they share, or share an edge with more than one, cells have CutCells::Cells::meets,
/// and pieces are found in floating point; likewise at vertices in which parts of the surface touch
/// that have walls across an axis, facing both ways, and where there are baffles.
///
/// A wall in a plane of the grid belongs to the cell whose fluid it bounds. What is said of a cell
/// depends on the planes around it alone: not on the box, on other cells or on the number of
/// threads. Areas, volumes and centroids are sums over fragments of triangles (divergence theorem).
///
/// Making one takes as long as cutting some twenty thousand cells; make one for many boxes. A box
/// takes time for its own cells, and for the triangles in it and below it. Copies share the
/// surface. cut() is const and thread-safe.
class CellCutter {
 public:
  /// @param solid  a MeshSDF, placed anyhow: its vertices are rounded in the world.
  /// @param side  where the fluid is.
  /// @param options  see there.
  /// @throws Error(Argument) for other solids, for open patches and baffles that there are none of,
  /// that are named twice, or as both; Error(Topology) unless the surface, without baffles, is
  /// closed, or is to be, and can be oriented, see MeshSDF::signReport(), and if all of its
  /// triangles cancel each other.
  template <std::floating_point T>
  explicit CellCutter(const Solid<T>& solid, FluidSide side = FluidSide::Outside,
                      const CutterOptions& options = {});

  /// The cells of a box.
  /// @throws Error(Argument) unless planes ascend and are finite, and options are within their
  /// ranges, and unless they are those of cellsOfPeriod() if there is a period; Error(Topology)
  /// where an open patch lies in a cell of the box, but in none of its faces, which is decided
  /// exactly.
  [[nodiscard]] CutCells cut(const CellPlanes& grid, const CutOptions& options = {}) const;
  /// Those of a grid patch.
  template <std::floating_point T>
  [[nodiscard]] CutCells cut(const GridPatch<T>& gridPatch, const CutOptions& options = {}) const {
    return cut(gridOf(gridPatch), options);
  }

  /// The cells of a box, which may lie anywhere, of a grid that repeats along the axes that have a
  /// period: `planes` are those between the cells of one period, `first` is the index of the lowest
  /// cell. Cells a whole number of periods apart have planes that are exactly so far apart. Along
  /// other axes, the box must lie between the planes.
  /// @throws Error(Argument) unless there are two cells at least in a period, as long as it is but
  /// for rounding; as cellsBetween(); and if the box lies more than a few periods away, or four
  /// times as far from the origin as the body and the period reach.
  [[nodiscard]] CellPlanes cellsOfPeriod(const std::array<std::vector<double>, 3>& planes,
                                         const Index3& first, const IndexBox& box) const;
  /// The period along each axis, as it was rounded; 0: there is none.
  [[nodiscard]] Vec3<double> period() const;

  /// The leaves of an octree, or of a part of one: arcs to leaves that it has not lead to kBeyond.
  /// What is said of a leaf depends on it, on the leaves across its faces and on their levels
  /// alone; its polygons have corners of the leaves across its edges as well. An octree of one
  /// level gives the pieces and arcs of the grid patch, to the bit.
  /// @throws Error(Argument) if leaves are so small that their planes do not ascend, and unless
  /// options are within their ranges; if there is a period; Error(Topology) as of cells.
  template <std::floating_point T>
  [[nodiscard]] CutLeaves cut(const OctreeCells<T>& mesh, const CutOptions& options = {}) const;

  /// In 2D: the rectangles between the grid's planes across x and y, in the plane at `z`, of which
  /// the answers are as exact as of cells.
  ///
  /// They are given as one layer of cells, the grid's first one along z, from z - 1/2 to z + 1/2,
  /// as if the solid were its section there, so volumes are areas and areas are lengths. For
  /// axially symmetric flow about the y axis, 2 pi times x of a centroid is the weight of a volume
  /// or an area.
  /// @throws Error(Argument) as cut(); unless z +- 1/2 differ; if polygons, moments or quadrature
  /// are asked for, there is a period, or a triangle of a baffle lies in the plane. Error(Topology)
  /// as cut() with polygons.
  [[nodiscard]] CutCells cutInPlane(const CellPlanes& grid, double z,
                                    const CutOptions& options = {}) const;

  /// The cells in which caps and a MeshSDF of the open surface may disagree: those that have points
  /// in the body where the winding number without caps, by which a MeshSDF decides, is below 1/2 -
  /// 1/4096, or points outside of it where that is above 1/2 + 1/4096. Sorted as rows are, cut or
  /// not; empty if there are no caps.
  ///
  /// Every cell that has such points is among them. Some others are, near such points, but none
  /// because of caps in one plane alone, within single precision: see Docs/cut-cells.md. Time grows
  /// with the cells near caps.
  /// @param cells  what cut() gave for boxes of cells, or coarsened() of that.
  /// @param options  see ParallelOptions.
  /// @throws Error(Argument) if there is a period.
  [[nodiscard]] std::vector<Index3> disputedCells(const CutCells& cells,
                                                  const ParallelOptions& options = {}) const;
  /// Of the rectangles that cutInPlane() gave for this z, those that have such points.
  [[nodiscard]] std::vector<Index3> disputedCellsInPlane(const CutCells& cells, double z,
                                                         const ParallelOptions& options = {}) const;
  /// Of the leaves that cut() gave for this octree: their indices, ascending.
  /// @throws Error(Argument) if the octree has another number of leaves.
  template <std::floating_point T>
  [[nodiscard]] std::vector<std::uint32_t> disputedLeaves(
      const CutLeaves& leaves, const OctreeCells<T>& mesh,
      const ParallelOptions& options = {}) const;

 private:
  template <std::floating_point T>
  [[nodiscard]] CellPlanes gridOf(const GridPatch<T>& gridPatch) const;

  std::shared_ptr<const CutSurface> surface_;
  std::shared_ptr<const CapAngles> caps_;  // null: there are none
};

/// The planes between the cells of a grid patch; around its control volumes, if it has nodes.
template <std::floating_point T>
[[nodiscard]] CellPlanes planesOf(const GridPatch<T>& gridPatch);

/// Options of a SolidCutter.
struct SolidCutterOptions {
  /// Points of each Gauss rule, from 1 to 6: errors of volumes and open parts fall as the cell's
  /// width to the power of twice that, where the wall is smooth.
  int points = 3;
  /// Where open parts and wall of a cell, or of a face, close no better than this, in shares of its
  /// largest side, it is halved up to three times.
  double tolerance = 1e-5;
  /// The period of the body along each axis, 0: none. The body is the union of the solid with all
  /// its images whole periods away. Along an axis without bounds, as of a triply periodic wall, the
  /// solid must repeat itself, which is looked at in a hundred points. The period is rounded as by
  /// CutterOptions::period.
  Vec3<double> period = {};
};

/// Options of SolidCutter::certified().
struct CertifyOptions {
  /// Intervals are no wider than this, from 0 to 1. Half of it takes four times as long for cells,
  /// and twice as long for faces.
  double width = 0.1;
  /// The search ends after so many boxes of a cell, or of a face: then its interval is wider.
  std::size_t boxes = 10'000;
  /// Whether to look at the number of pieces, too, by as many boxes of each cell: see
  /// CertifiedCells::undecided.
  bool pieces = false;
  /// See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// What is certain about the cells of a box, whatever rows say: intervals that enclose the shares.
struct CertifiedCells {
  /// Of each row of cells of the box: the share of the cell that is fluid.
  std::vector<Interval<double>> volumeFraction;
  /// Of each arc: the share of its face that is open, in all arcs of the face together.
  std::vector<Interval<double>> aperture;

  /// A cell of the box without a row, of which nothing proves that it is all fluid or all body. It
  /// may hold a part of the body that the rows miss, or the surface only touches it.
  struct Doubtful {
    Index3 cell;
    Interval<double> volumeFraction;
  };
  std::vector<Doubtful> doubtful;  ///< sorted as rows are
  /// On request, see CertifyOptions::pieces: rows of cells whose number of pieces is not proven. It
  /// is where boxes that are all fluid connect each piece in itself, and boxes that are all body
  /// part it from the others, as far as boxes are needed until those in which the surface may be
  /// are no larger together than CertifyOptions::width. Pieces without any box that is all fluid
  /// are taken for granted.
  std::vector<std::uint32_t> undecided;
};

/// The same of the leaves of an octree.
struct CertifiedLeaves {
  std::vector<Interval<double>> volumeFraction;  ///< of each row
  /// Of each arc: the share of the finer leaf's face that is open, in all arcs of that face.
  std::vector<Interval<double>> aperture;

  /// See CertifiedCells::Doubtful.
  struct Doubtful {
    std::uint32_t leaf = 0;
    Interval<double> volumeFraction;
  };
  std::vector<Doubtful> doubtful;        ///< ascending
  std::vector<std::uint32_t> undecided;  ///< rows, see CertifiedCells::undecided
};

/// Cuts the cells of grids by any solid: shapes, their unions, differences and blends, lattices,
/// triply periodic walls, functions of one's own. Rows are as those that a CellCutter makes of
/// meshes, which are exact; here they are found by quadrature of the solid itself, without a mesh
/// between (dimension reduction, Saye 2015), and CutCells::Cells::error estimates by how much they
/// are off.
///
/// Lines along an axis in which the wall is a graph are cut at roots of the solid's values, at
/// Gauss points between the places where the wall leaves through the ends of lines, or has an edge.
/// Open parts are found of each face alone, so that both of its cells have the same bits; the
/// wall's vector is what closes a piece. What lies in the surface within rounding counts as body: a
/// wall in a plane of the grid belongs to the cell whose fluid it bounds.
///
/// Where a solid tells in which surfaces its walls lie (Solid::surfacesIn()), lines are divided
/// where they cross these: so thin parts and edges are found.
///
/// Cells are left out where the values at corners, with the solid's Lipschitz constant, exclude a
/// wall. A wall that meets no edge of a cell is found where derivatives at the corners lead to it.
/// Solids without a constant are cut where corners have different signs. Pieces are told apart by
/// whether paths along the axes meet no wall; certified() proves it.
///
/// cut() is const and thread-safe. What is said of a cell depends on the planes around it alone.
class SolidCutter {
 public:
  /// @param solid  any; of a mesh, a CellCutter finds exact rows, and faster.
  /// @param side  where the fluid is.
  /// @param options  see there.
  /// @throws Error(Argument) unless options are within their ranges, and for a solid without bounds
  /// that does not repeat itself.
  template <std::floating_point T>
  explicit SolidCutter(const Solid<T>& solid, FluidSide side = FluidSide::Outside,
                       const SolidCutterOptions& options = {});

  /// The cells of a box.
  /// @throws Error(Argument) unless planes ascend and are finite, and options are within their
  /// ranges, and unless they are those of cellsOfPeriod() if there is a period.
  [[nodiscard]] CutCells cut(const CellPlanes& grid, const CutOptions& options = {}) const;
  /// Those of a grid patch.
  template <std::floating_point T>
  [[nodiscard]] CutCells cut(const GridPatch<T>& gridPatch, const CutOptions& options = {}) const {
    return cut(gridOf(gridPatch), options);
  }

  /// As those of a CellCutter.
  [[nodiscard]] CellPlanes cellsOfPeriod(const std::array<std::vector<double>, 3>& planes,
                                         const Index3& first, const IndexBox& box) const;
  [[nodiscard]] Vec3<double> period() const;

  /// The leaves of an octree, or of a part of one, as CellCutter::cut() gives them. An octree of
  /// one level gives the pieces and arcs of the grid patch, to the bit.
  /// @throws Error(Argument) if leaves are so small that their planes do not ascend, and unless
  /// options are within their ranges, and if there is a period.
  template <std::floating_point T>
  [[nodiscard]] CutLeaves cut(const OctreeCells<T>& mesh, const CutOptions& options = {}) const;

  /// In 2D: the rectangles between the grid's planes across x and y, in the plane at `z`, as
  /// CellCutter::cutInPlane() gives them.
  /// @throws Error(Argument) as cut(); unless z +- 1/2 differ; for polygons, moments and
  /// quadrature, and if there is a period.
  [[nodiscard]] CutCells cutInPlane(const CellPlanes& grid, double z,
                                    const CutOptions& options = {}) const;

  /// Bounds of what cut() gave for boxes of cells, or coarsened() of that: by classify(), in boxes
  /// that are halved until they are certainly all fluid or all body. Where the solid's guarantee
  /// proves nothing, intervals are from 0 to 1. A face that has a wall in its plane is both open
  /// and closed, as far as that can prove.
  /// @throws Error(Argument) unless options are within their ranges, and for planes that are no
  /// numbers of the solid's precision.
  [[nodiscard]] CertifiedCells certified(const CutCells& cells,
                                         const CertifyOptions& options = {}) const;
  /// Of the leaves that cut() gave for this octree.
  /// @throws Error(Argument) also if the octree has another number of leaves.
  template <std::floating_point T>
  [[nodiscard]] CertifiedLeaves certified(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                                          const CertifyOptions& options = {}) const;
  /// Of the rectangles that cutInPlane() gave for this z.
  [[nodiscard]] CertifiedCells certifiedInPlane(const CutCells& cells, double z,
                                                const CertifyOptions& options = {}) const;

 private:
  [[nodiscard]] CutCells cut(const FluidField& field, const CellPlanes& grid,
                             const CutOptions& options) const;
  template <std::floating_point T>
  [[nodiscard]] CellPlanes gridOf(const GridPatch<T>& gridPatch) const;

  std::shared_ptr<const CutPeriod> period_;
  std::shared_ptr<const FluidField> field_;
  SolidCutterOptions options_;
};

extern template CellCutter::CellCutter(const Solid<float>&, FluidSide, const CutterOptions&);
extern template CellCutter::CellCutter(const Solid<double>&, FluidSide, const CutterOptions&);
extern template SolidCutter::SolidCutter(const Solid<float>&, FluidSide, const SolidCutterOptions&);
extern template SolidCutter::SolidCutter(const Solid<double>&, FluidSide,
                                         const SolidCutterOptions&);
extern template CutLeaves SolidCutter::cut(const OctreeCells<float>&, const CutOptions&) const;
extern template CutLeaves SolidCutter::cut(const OctreeCells<double>&, const CutOptions&) const;
extern template CertifiedLeaves SolidCutter::certified(const CutLeaves&, const OctreeCells<float>&,
                                                       const CertifyOptions&) const;
extern template CertifiedLeaves SolidCutter::certified(const CutLeaves&, const OctreeCells<double>&,
                                                       const CertifyOptions&) const;
extern template CutLeaves CellCutter::cut(const OctreeCells<float>&, const CutOptions&) const;
extern template CutLeaves CellCutter::cut(const OctreeCells<double>&, const CutOptions&) const;
extern template std::vector<std::uint32_t> CellCutter::disputedLeaves(const CutLeaves&,
                                                                      const OctreeCells<float>&,
                                                                      const ParallelOptions&) const;
extern template std::vector<std::uint32_t> CellCutter::disputedLeaves(const CutLeaves&,
                                                                      const OctreeCells<double>&,
                                                                      const ParallelOptions&) const;
extern template CellPlanes SolidCutter::gridOf(const GridPatch<float>&) const;
extern template CellPlanes SolidCutter::gridOf(const GridPatch<double>&) const;
extern template CellPlanes CellCutter::gridOf(const GridPatch<float>&) const;
extern template CellPlanes CellCutter::gridOf(const GridPatch<double>&) const;
extern template CellPlanes planesOf(const GridPatch<float>&);
extern template CellPlanes planesOf(const GridPatch<double>&);

}  // namespace cutwater
