#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>

#include <algorithm>

namespace cutwater {

/// The parts of a piece's wall, in the order of patches.
[[nodiscard]] std::span<const PieceWall> wallsOf(const CellPieces& content, std::uint32_t piece);

/// Makes room for so many rows.
void reserveRows(std::size_t cells, CutCells::Cells& rows);
void reserveRows(std::size_t pieces, std::size_t walls, CutCells::Pieces& rows,
                 CutCells::WallParts& wallParts);
void reserveRows(std::size_t arcs, CutCells::Arcs& rows);

/// Appends a piece of a tile, in the coordinates of the world, to the rows of the cell `row`.
void addPieceRows(const CellPieces& content, std::uint32_t piece, const CutFrame& frame,
                  std::uint32_t row, CutCells::Pieces& pieces, CutCells::WallParts& wallParts);

/// In which faces of a cell the walls of the tile's pieces [first, last) lie, as
/// CutCells::Cells::wallFaces.
[[nodiscard]] std::uint8_t wallFacesOf(const CellPieces& content, std::uint32_t first,
                                       std::uint32_t last);

/// Appends the moments of a piece or an arc of a tile.
void addPieceMoments(const CutCells::Moments& from, std::uint32_t piece, CutCells::Moments& to);
void addArcMoments(const CutCells::Moments& from, std::uint32_t arc, CutCells::Moments& to);

/// Appends a row of points of a tile, moved.
void addPointRow(const CutCells::PointRows& from, std::uint32_t row, const Vec3<double>& shift,
                 CutCells::PointRows& to);
/// Appends those of a piece and its wall.
void addPiecePoints(const CutCells::Quadrature& from, std::uint32_t piece,
                    const Vec3<double>& shift, CutCells::Quadrature& to);

/// A point of a tile in the coordinates of the world: in its planes to the bit, also where these
/// are rounded in the frame.
///
/// `within`: a cell of the tile or a face below it, in which the point lies; `cells`: of the tile,
/// along each axis. `planeOf(axis, number)`: a plane of the tile, in the frame and in the world.
template <typename PlaneOf>
[[nodiscard]] Vec3<double> inWorld(const Vec3<double>& point, const CutFrame& frame,
                                   const TilePlace& within, const TilePlace& cells,
                                   const PlaneOf& planeOf) {
  auto p = frame.toWorld(point);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (int number = within[a]; number <= std::min(within[a] + 1, cells[a]); ++number) {
      const auto [inFrame, plane] = planeOf(axis, number);
      if (point[axis] == inFrame) p[axis] = plane;
    }
  }
  return p;
}

}  // namespace cutwater
