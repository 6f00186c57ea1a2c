#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <unordered_map>

namespace cutwater {

/// The wall in the cells of a tile as polygons, for pictures and for what must have corners: cells
/// are divided into smaller ones, these into six tetrahedra along their diagonal (Freudenthal 1942;
/// Kuhn 1960), and the wall passes through edges whose ends are on two sides. So polygons fit
/// together in faces and cells, whatever is smaller than the lattice. Points are in the surface;
/// volumes and areas are those of rows but for the second order of the lattice's width. What lies
/// in planes beyond the seam is found a period below.
class WallLattice {
 public:
  /// Views both.
  WallLattice(const FluidField& field, const GridPlanes& planes);

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
  [[nodiscard]] std::vector<Triangle> wallIn(const TilePlace& cell);
  static constexpr int kPerSide = 2;

  [[nodiscard]] Vec3<double> pointOf(const TilePlace& node) const;
  [[nodiscard]] Vec3<double> shiftOf(const TilePlace& node) const;
  [[nodiscard]] double valueAt(const TilePlace& node);
  [[nodiscard]] bool isFluid(const TilePlace& node) { return valueAt(node) > 0; }
  [[nodiscard]] const Vec3<double>& crossing(TilePlace from, TilePlace to);
  void addTetrahedron(const std::array<TilePlace, 4>& nodes, std::vector<Triangle>& to);

  const FluidField& field_;
  const GridPlanes& planes_;
  TileSizes nodes_;
  std::vector<double> values_;
  std::unordered_map<std::uint64_t, Vec3<double>> crossings_;
};

}  // namespace cutwater
