#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileNumbers.hpp>

#include <array>
#include <vector>

namespace cutwater {

/// How the leaves of an octree divide what is around the cells of a tile. Places are counted from
/// its first cell.
struct LeavesAround {
  int levels = 0;  ///< of the octree, below that of the cells
  /// The planes of its finest level across an axis.
  FunctionRef<double(int axis, std::int32_t plane)> plane;
  /// Whether a cell that is so many levels below is divided into leaves.
  FunctionRef<bool(const TilePlace& cell, int below)> isDivided;
};

/// The cells of a tile divided into cubes of half their width, and these into six tetrahedra along
/// their diagonal (Freudenthal 1942; Kuhn 1960), which fit together in all faces.
///
/// A cube of a leaf with finer ones across some of its faces or edges has the triangles of their
/// lattice there. A face of which only edges are divided is made of triangles from its middle, the
/// cube of tetrahedra from its own: both sides of a face divide it alike.
class CellLattice {
 public:
  using Triangle = std::array<TilePlace, 3>;
  using Tetrahedron = std::array<TilePlace, 4>;

  /// Views its arguments. `leaves`: if the cells are some of these; may be null.
  CellLattice(const GridPlanes& planes, const LeavesAround* leaves)
      : planes_(planes), leaves_(leaves), width_(leaves != nullptr ? 1 << leaves->levels : 1) {}

  /// Calls visit() for the triangles of the face below a cell, around the axis.
  void forTriangles(int axis, const TilePlace& cell,
                    FunctionRef<void(const Triangle&)> visit) const;
  void forTetrahedra(const TilePlace& cell, FunctionRef<void(const Tetrahedron&)> visit) const;

  [[nodiscard]] Vec3<double> pointOf(const TilePlace& node) const;
  /// How far below a node what is there is computed: see GridPlanes::seam.
  [[nodiscard]] Vec3<double> shiftOf(const TilePlace& node) const;

 private:
  [[nodiscard]] TilePlace firstNodeOf(TilePlace cell) const;
  [[nodiscard]] double planeAt(int axis, int plane) const;
  /// Whether nodes of finer leaves are within an edge or a square, which has these lengths.
  [[nodiscard]] bool isDivided(const TilePlace& first, const TilePlace& lengths) const;
  /// Appends the nodes of an edge, without its end.
  void addEdge(const TilePlace& first, int axis, int width, std::vector<TilePlace>& to) const;
  [[nodiscard]] std::vector<TilePlace> rimOf(int axis, const TilePlace& first, int width) const;
  /// Of a square.
  void divide(int axis, const TilePlace& first, int width,
              FunctionRef<void(const Triangle&)> visit) const;
  /// Of a cube.
  void divide(const TilePlace& first, FunctionRef<void(const Tetrahedron&)> visit) const;

  const GridPlanes& planes_;
  const LeavesAround* leaves_;
  int width_;  // of a cube, in nodes
};

}  // namespace cutwater
