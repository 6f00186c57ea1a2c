#include <Cutwater/CutCells/Detail/Pieces/WallFaces.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using Triangle = std::array<Vec3<double>, 3>;

/// A face of a cell.
struct CellFace {
  int axis = -1;  ///< -1: none
  bool isHigh = false;

  [[nodiscard]] bool isNone() const { return axis < 0; }
  [[nodiscard]] std::uint8_t bit() const { return bitOfFace(axis, isHigh); }
};

/// In whose plane a triangle lies.
CellFace faceOf(const Triangle& triangle, const GridPlanes& planes, const TilePlace& cell) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!lieAcross(triangle, axis)) continue;
    const double at = triangle[0][axis];
    for (const bool isHigh : {false, true}) {
      if (planes.at(axis, cell[asIndex(axis)] + (isHigh ? 1 : 0)) == at) return {axis, isHigh};
    }
  }
  return {};
}

/// Whether an edge of a triangle that lies across an axis has these points on its outer side, or on
/// it.
template <std::size_t Count>
bool leavesOut(const Triangle& triangle, std::size_t edge, int axis,
               const std::array<Vec3<double>, Count>& points) {
  const auto& p = triangle[edge];
  const auto& q = triangle[(edge + 1) % 3];
  const int inner = crossSign(p, q, p, triangle[(edge + 2) % 3], axis);
  return std::ranges::all_of(
      points, [&](const Vec3<double>& point) { return crossSign(p, q, p, point, axis) != inner; });
}

/// The places of a triangle along an axis.
Interval<double> rangeAlong(const Triangle& triangle, int axis) {
  const auto [lower, upper] =
      std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
  return {lower, upper};
}

bool hasAreaAcross(const Triangle& triangle, int axis) {
  return crossSign(triangle[0], triangle[1], triangle[0], triangle[2], axis) != 0;
}

/// Whether a triangle in the plane of a face has an area in it: else a side of either separates
/// them.
bool hasPartIn(const Triangle& triangle, const GridPlanes& planes, const TilePlace& cell,
               int axis) {
  if (!hasAreaAcross(triangle, axis)) return false;
  const int c = (axis + 1) % 3;
  const int d = (axis + 2) % 3;
  std::array<Vec3<double>, 4> corners;
  for (std::size_t n = 0; n < 4; ++n) {
    corners[n][axis] = triangle[0][axis];
    corners[n][c] = planes.at(c, cell[asIndex(c)] + static_cast<int>(n % 2));
    corners[n][d] = planes.at(d, cell[asIndex(d)] + static_cast<int>(n / 2));
  }
  for (const int along : {c, d}) {
    const auto [lower, upper] = rangeAlong(triangle, along);
    if (upper <= corners[0][along] || lower >= corners[3][along]) return false;
  }
  for (std::size_t edge = 0; edge < 3; ++edge) {
    if (leavesOut(triangle, edge, axis, corners)) return false;
  }
  return true;
}

std::uint8_t faceWithPart(const TileSurface& surface, const GridPlanes& planes,
                          const TileFragment& fragment) {
  // What a triangle in a plane has in a cell lies in it, too, and is nearer at hand.
  const auto points = surface.points(fragment);
  if (!lieAcross(points, 0) && !lieAcross(points, 1) && !lieAcross(points, 2)) return 0;
  if (surface.patchOf(fragment.triangle) == kNone) return 0;
  const auto triangle = surface.cornersOf(fragment.triangle);
  const auto cell = surface.numbers().placeOfCell(fragment.cell);
  const auto face = faceOf(triangle, planes, cell);
  if (face.isNone() || !hasPartIn(triangle, planes, cell, face.axis)) return 0;
  return face.bit();
}

/// Of the cells where triangles meet: polygons of walls in a face that triangles lie in.
void noteMeetingWalls(const TileSurface& surface, const GridPlanes& planes, CellPieces& content) {
  const auto& [of, polygons] = content.meetingWalls;
  for (std::size_t n = 0; n < of.size(); ++n) {
    auto& piece = content.pieces[of[n].first];
    if (of[n].second == kNone || WallPolygons::isOfArc(of[n].second)) continue;
    const auto cell = surface.numbers().placeOfCell(piece.cell);
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool isHigh : {false, true}) {
        const double plane = planes.at(axis, cell[asIndex(axis)] + (isHigh ? 1 : 0));
        const bool isIn = std::ranges::all_of(
            polygons.of(n), [&](const Vec3<double>& p) { return p[axis] == plane; });
        if (isIn) piece.wallFaces |= bitOfFace(axis, isHigh);
      }
    }
  }
}

}  // namespace

void noteWallFaces(const TileSurface& surface, const GridPlanes& planes, CellPieces& content) {
  noteMeetingWalls(surface, planes, content);
  const auto fragments = surface.fragments();
  auto piece = content.pieces.begin();
  for (std::size_t i = 0; i < fragments.size();) {
    const auto cell = fragments[i].cell;
    std::uint8_t meeting = 0;  // faces in which triangles lie
    for (; i < fragments.size() && fragments[i].cell == cell; ++i) {
      const auto owner = content.ofFragments[i];
      const auto face = faceWithPart(surface, planes, fragments[i]);
      meeting |= face;
      if (owner != kNone && content.isWall(i)) content.pieces[owner].wallFaces |= face;
    }
    for (; piece != content.pieces.end() && piece->cell == cell; ++piece) {
      piece->wallFaces &= meeting;
    }
  }
}

std::uint8_t wallSideOf(const TileSurface& surface, const GridPlanes& planes, const TilePlace& cell,
                        std::uint32_t triangle, double z) {
  const auto corners = surface.cornersOf(triangle);
  const auto face = faceOf(corners, planes, cell);
  if (face.isNone() || face.axis == 2 || !hasAreaAcross(corners, face.axis)) return 0;
  const auto above = std::ranges::count_if(corners, [&](const auto& p) { return p.z > z; });
  const auto below = std::ranges::count_if(corners, [&](const auto& p) { return p.z < z; });
  if ((above == 0 || below == 0) && above + below > 1) return 0;  // at a corner at most
  const int along = 1 - face.axis;
  std::array<Vec3<double>, 2> ends;
  for (const int n : {0, 1}) {
    auto& end = ends[asIndex(n)];
    end[face.axis] = corners[0][face.axis];
    end[along] = planes.at(along, cell[asIndex(along)] + n);
    end.z = z;
  }
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const bool isInPlane = corners[edge].z == z && corners[(edge + 1) % 3].z == z;
    if (!isInPlane && leavesOut(corners, edge, face.axis, ends)) return 0;
  }
  return face.bit();
}

}  // namespace cutwater
