#include <Cutwater/CutCells/Detail/Rows/PieceRows.hpp>

#include <algorithm>

namespace cutwater {

namespace {

template <typename Value>
void append(std::span<const Value> values, std::vector<Value>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

template <typename... Vectors>
void reserve(std::size_t count, Vectors&... vectors) {
  (vectors.reserve(count), ...);
}

}  // namespace

std::span<const PieceWall> wallsOf(const CellPieces& content, std::uint32_t piece) {
  const auto& walls = content.walls;
  return {std::ranges::lower_bound(walls, piece, {}, &PieceWall::piece),
          std::ranges::upper_bound(walls, piece, {}, &PieceWall::piece)};
}

void reserveRows(std::size_t cells, CutCells::Cells& rows) {
  reserve(cells, rows.index, rows.fluidCorners, rows.meets, rows.wallFaces);
  rows.firstPiece.reserve(cells + 1);
}

void reserveRows(std::size_t pieces, std::size_t walls, CutCells::Pieces& rows,
                 CutCells::WallParts& wallParts) {
  reserve(pieces, rows.cell, rows.volume, rows.centroid, rows.wallArea, rows.wallVector,
          rows.wallCentroid, rows.wallFaces);
  reserve(walls, wallParts.piece, wallParts.patch, wallParts.area, wallParts.vector,
          wallParts.centroid);
}

void reserveRows(std::size_t arcs, CutCells::Arcs& rows) {
  reserve(arcs, rows.below, rows.above, rows.area, rows.centroid, rows.cell, rows.axis);
}

void addPieceRows(const CellPieces& content, std::uint32_t piece, const CutFrame& frame,
                  std::uint32_t row, CutCells::Pieces& pieces, CutCells::WallParts& wallParts) {
  const double perArea = frame.scale * frame.scale;
  for (const auto& wall : wallsOf(content, piece)) {
    wallParts.piece.push_back(static_cast<std::uint32_t>(pieces.volume.size()));
    wallParts.patch.push_back(wall.patch);
    wallParts.area.push_back(wall.area / perArea);
    wallParts.vector.push_back(wall.areaVector / perArea);
    wallParts.centroid.push_back(frame.toWorld(wall.centroid));
  }
  const auto& of = content.pieces[piece];
  pieces.cell.push_back(row);
  pieces.volume.push_back(of.volume / (perArea * frame.scale));
  pieces.centroid.push_back(frame.toWorld(of.centroid));
  pieces.wallArea.push_back(of.area / perArea);
  pieces.wallVector.push_back(of.areaVector / perArea);
  pieces.wallCentroid.push_back(frame.toWorld(of.wallCentroid));
  pieces.wallFaces.push_back(of.wallFaces);
}

std::uint8_t wallFacesOf(const CellPieces& content, std::uint32_t first, std::uint32_t last) {
  std::uint8_t faces = 0;
  for (auto p = first; p < last; ++p) faces |= content.pieces[p].wallFaces;
  return faces;
}

void addPieceMoments(const CutCells::Moments& from, std::uint32_t piece, CutCells::Moments& to) {
  append(from.ofVolume(piece), to.volume);
  append(from.ofWall(piece), to.wall);
  append(from.ofWallVector(piece), to.wallVector);
}

void addPointRow(const CutCells::PointRows& from, std::uint32_t row, const Vec3<double>& shift,
                 CutCells::PointRows& to) {
  if (to.first.empty()) to.first.push_back(0);
  for (const auto& point : from.pointsOf(row)) to.points.push_back(point + shift);
  append(from.weightsOf(row), to.weights);
  to.first.push_back(to.points.size());
}

void addPiecePoints(const CutCells::Quadrature& from, std::uint32_t piece,
                    const Vec3<double>& shift, CutCells::Quadrature& to) {
  addPointRow(from.volume, piece, shift, to.volume);
  addPointRow(from.wall, piece, shift, to.wall);
  const auto& first = from.wall.first;
  for (auto i = first[piece]; i < first[piece + 1]; ++i) {
    to.wallNormals.push_back(from.wallNormals[i]);
  }
}

void addArcMoments(const CutCells::Moments& from, std::uint32_t arc, CutCells::Moments& to) {
  append(from.ofArc(arc), to.arc);
}

}  // namespace cutwater
