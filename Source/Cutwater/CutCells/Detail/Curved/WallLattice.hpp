#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Curved/CellLattice.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <unordered_map>

namespace cutwater {

/// The wall in the cells of a tile as polygons, for pictures and for what must have corners: it
/// passes through those edges of a lattice whose ends are on two sides. So polygons fit together in
/// faces and cells, whatever is smaller than the lattice. Points are in the surface; volumes and
/// areas are those of rows but for the second order of the lattice's width. What lies in planes
/// beyond the seam is found a period below.
class WallLattice {
 public:
  /// Views its arguments.
  WallLattice(const FluidField& field, const GridPlanes& planes, const CellLattice& lattice)
      : field_(field), planes_(planes), lattice_(lattice) {}

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
  void addTetrahedron(const CellLattice::Tetrahedron& nodes, std::vector<Triangle>& to);
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
  const CellLattice& lattice_;
  std::unordered_map<TilePlace, double, Hash> values_;
  std::unordered_map<Edge, Vec3<double>, Hash> crossings_;
};

}  // namespace cutwater
