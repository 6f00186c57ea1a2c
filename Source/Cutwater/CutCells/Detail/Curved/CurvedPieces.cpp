#include <Cutwater/CutCells/Detail/Curved/CurvedPieces.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace cutwater {

namespace {

/// In which faces of the cell walls lie, see CutCells::Cells::wallFaces.
std::uint8_t wallFaces(const Box<double>& box, std::span<const WallPoint> walls) {
  constexpr double kAcross = 1 - 1e-12;
  unsigned faces = 0;
  for (const auto& wall : walls) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(wall.normal[axis]) < kAcross) continue;
      if (wall.at[axis] == box.lower[axis]) faces |= 1U << static_cast<unsigned>(2 * axis);
      if (wall.at[axis] == box.upper[axis]) faces |= 2U << static_cast<unsigned>(2 * axis);
    }
  }
  return static_cast<std::uint8_t>(faces);
}

}  // namespace

void addPiece(const FluidField& field, const Box<double>& box, std::uint32_t cell,
              const PieceRule& rule, CellPieces& to) {
  CellPiece piece{.cell = cell,
                  .volume = rule.volume,
                  .centroid = box.center(),
                  .areaVector = {},
                  .wallCentroid = {}};
  if (rule.volume > 0) {
    piece.centroid = rule.points.spans.front().middle() + rule.moment / rule.volume;
  }
  std::map<std::uint32_t, PieceWall> walls;
  const auto patches = field.patchNames().size();
  for (const auto& point : rule.points.walls) {
    const auto patch =
        patches > 1 ? std::min(field.owner(point.at).patch, static_cast<std::uint32_t>(patches - 1))
                    : 0;
    auto& wall = walls[patch];
    wall.area += point.weight;
    wall.areaVector += point.weight * point.normal;
    wall.centroid += point.weight * (point.at - piece.centroid);
  }
  piece.wallCentroid = piece.centroid;
  Vec3<double> moment;
  for (auto& [patch, wall] : walls) {
    piece.area += wall.area;
    moment += wall.centroid;
    wall.piece = static_cast<std::uint32_t>(to.pieces.size());
    wall.patch = patch;
    wall.centroid = piece.centroid + wall.centroid / wall.area;
    to.walls.push_back(wall);
  }
  if (piece.area > 0) piece.wallCentroid += moment / piece.area;
  piece.wallFaces = wallFaces(box, rule.points.walls);
  to.pieces.push_back(withinCell(piece, box));
}

}  // namespace cutwater
