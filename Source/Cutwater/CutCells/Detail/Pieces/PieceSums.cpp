#include <Cutwater/CutCells/Detail/Pieces/PieceSums.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

PieceWall& PieceSums::wallOf(std::uint32_t patch) {
  const auto found = std::ranges::find(walls_, patch, &PieceWall::patch);
  if (found != walls_.end()) return *found;
  walls_.push_back({.patch = patch, .areaVector = {}, .centroid = {}});
  return walls_.back();
}

void PieceSums::addWall(std::span<const Vec3<double>> polygon, std::uint32_t patch) {
  if (patch != kNone) addPolygon(polygon, wallOf(patch));
}

void PieceSums::addPolygon(std::span<const Vec3<double>> polygon, PieceWall& wall) {
  const auto a = polygon[0] - reference_;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const auto b = polygon[k - 1] - reference_;
    const auto c = polygon[k] - reference_;
    const auto area = -0.5 * cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    const auto middle = (a + b + c) / 3.0;
    const double volume = dot(a, area);
    const double size = length(area);
    wall.areaVector += area;
    wall.area += size;
    wall.centroid += size * middle;
    volume_ += volume;
    moment_ += volume * middle;
  }
}

void PieceSums::addOpenPart(double distance, double area, const Vec3<double>& centroid) {
  volume_ += distance * area;
  openArea_ += std::abs(area);
  moment_ += distance * area * (centroid - reference_);
}

double PieceSums::area() const {
  double area = openArea_ + openPatches_.area;
  for (const auto& wall : walls_) area += wall.area;
  return area;
}

bool PieceSums::isNothing(const Vec3<double>& cellSize, double share) const {
  return area() <= nothing(cellSize, share);
}

CellPiece PieceSums::piece(std::uint32_t cell) const {
  CellPiece result{.cell = cell,
                   .volume = volume_ / 3,
                   .centroid = reference_,
                   .areaVector = {},
                   .wallCentroid = {}};
  if (result.volume > 0) result.centroid += moment_ / (4 * result.volume);
  for (const auto& wall : walls_) {
    result.area += wall.area;
    result.areaVector += wall.areaVector;
    result.wallCentroid += wall.centroid;
  }
  result.wallCentroid =
      result.area > 0 ? reference_ + result.wallCentroid / result.area : result.centroid;
  return result;
}

void PieceSums::appendWalls(std::uint32_t piece, std::vector<PieceWall>& walls) {
  std::ranges::sort(walls_, {}, &PieceWall::patch);
  for (auto wall : walls_) {
    if (!(wall.area > 0)) continue;
    wall.piece = piece;
    wall.centroid = reference_ + wall.centroid / wall.area;
    walls.push_back(wall);
  }
}

namespace {

/// In shares of a cell: volumes that are rounding.
constexpr double kFilm = 1e-12;

}  // namespace

CellPiece withinCell(CellPiece piece, const Box<double>& cell) {
  const auto size = cell.size();
  const bool isRounding = piece.volume > -kFilm * size.x * size.y * size.z;
  if (piece.volume < 0 && isRounding) piece.volume = 0;
  piece.centroid = max(cell.lower, min(cell.upper, piece.centroid));
  piece.wallCentroid = max(cell.lower, min(cell.upper, piece.wallCentroid));
  return piece;
}

}  // namespace cutwater
