#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <unordered_map>

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

/// The wall in the cells of a tile as polygons, for pictures and for what must have corners: cells
/// are divided into cubes of half their width, these into six tetrahedra along their diagonal
/// (Freudenthal 1942; Kuhn 1960), and the wall passes through edges whose ends are on two sides. So
/// polygons fit together in faces and cells, whatever is smaller than the lattice. Points are in
/// the surface; volumes and areas are those of rows but for the second order of the lattice's
/// width. What lies in planes beyond the seam is found a period below.
///
/// A cube of a leaf with finer ones across some of its faces or edges has the triangles of their
/// lattice there. A face of which only edges are divided is made of triangles from its middle, the
/// cube of tetrahedra from its own: both sides of a face divide it alike.
class WallLattice {
 public:
  /// Views its arguments. `leaves`: if the cells are some of these.
  WallLattice(const FluidField& field, const GridPlanes& planes,
              const LeavesAround* leaves = nullptr);

  /// Appends an outline of each open part of the face below a cell, empty if no node of the lattice
  /// sees it. Depends on the face alone.
  void addOutlines(int axis, const TilePlace& cell, const CurvedFace& face, CutCells::Polygons& to);

  /// Appends the wall in a cell, by the pieces of the tile to which points in the fluid belong.
  void addWalls(const TilePlace& cell,
                FunctionRef<std::uint32_t(const Vec3<double>& point)> pieceAt,
                const CellPieces& pieces, TilePolygons& to);

 private:
  /// A triangle of the wall with its normal into the fluid, and a node there.
  struct Triangle {
    std::array<Vec3<double>, 3> corners;
    Vec3<double> inFluid;
  };
  /// Calls visit(nodes) for the triangles of a square of the lattice, around the axis.
  template <typename Visit>
  void forTriangles(int axis, const TilePlace& first, int width, const Visit& visit) const;
  /// Appends the nodes of an edge, without its end.
  void addEdge(const TilePlace& first, int axis, int width, std::vector<TilePlace>& to) const;
  /// Whether nodes of finer leaves are within an edge or a square, which has these lengths.
  [[nodiscard]] bool isDivided(const TilePlace& first, const TilePlace& lengths) const;
  [[nodiscard]] bool isDividedCell(const TilePlace& cell, int below) const;

  [[nodiscard]] std::vector<Triangle> wallIn(const TilePlace& cell);
  void addCube(const TilePlace& first, std::vector<Triangle>& to);
  void addTetrahedron(const std::array<TilePlace, 4>& nodes, std::vector<Triangle>& to);

  [[nodiscard]] TilePlace firstNodeOf(TilePlace cell) const;
  [[nodiscard]] double planeAt(int axis, int plane) const;
  [[nodiscard]] Vec3<double> pointOf(const TilePlace& node) const;
  [[nodiscard]] Vec3<double> shiftOf(const TilePlace& node) const;
  [[nodiscard]] double valueAt(const TilePlace& node);
  [[nodiscard]] bool isFluid(const TilePlace& node) { return valueAt(node) > 0; }
  [[nodiscard]] const Vec3<double>& crossing(TilePlace from, TilePlace to);

  using Edge = std::array<TilePlace, 2>;
  struct Hash {
    [[nodiscard]] std::size_t operator()(const TilePlace& node) const;
    [[nodiscard]] std::size_t operator()(const Edge& edge) const;
  };

  const FluidField& field_;
  const GridPlanes& planes_;
  const LeavesAround* leaves_;
  int width_;                       // of a cube, in nodes
  TileSizes around_;                // the cells of the tile and those around it
  std::vector<char> dividedCells_;  // of these
  std::unordered_map<TilePlace, double, Hash> values_;
  std::unordered_map<Edge, Vec3<double>, Hash> crossings_;
};

}  // namespace cutwater
