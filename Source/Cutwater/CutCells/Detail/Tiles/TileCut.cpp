#include <Cutwater/CutCells/Detail/Faces/FaceOutlines.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceRegions.hpp>
#include <Cutwater/CutCells/Detail/Faces/RegionOutlines.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>
#include <Cutwater/CutCells/Detail/Moments/TileMoments.hpp>
#include <Cutwater/CutCells/Detail/Pieces/ConformedWalls.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallFaces.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/TileQuadrature.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// In shares of a cell and of a face: what is less is rounding of points on the cell's faces.
constexpr double kTouching = 1e-14;

/// Whether a cell's fragments lie in its faces and have no area: the surface touches the cell.
bool touches(const TileSurface& surface, std::span<const TileFragment> fragments,
             const GridPlanes& planes, double faceArea) {
  const auto cell = surface.numbers().placeOfCell(fragments.front().cell);
  return std::ranges::all_of(fragments, [&](const TileFragment& fragment) {
    const auto points = surface.points(fragment);
    bool isInFace = false;
    for (int axis = 0; axis < 3 && !isInFace; ++axis) {
      for (const int side : {0, 1}) {
        const double plane = planes.at(axis, cell[asIndex(axis)] + side);
        isInFace = isInFace || std::ranges::all_of(
                                   points, [&](const Vec3<double>& p) { return p[axis] == plane; });
      }
    }
    if (!isInFace) return false;
    return 0.5 * length(twiceArea(points)) <= kTouching * faceArea;
  });
}

std::uint8_t fluidCorners(const EdgeStretches& stretches, const TilePlace& cell) {
  unsigned bits = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const TilePlace node{cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                         cell[2] + (corner >> 2)};
    bits |= (stretches.isFluid(node) ? 1U : 0U) << static_cast<unsigned>(corner);
  }
  return static_cast<std::uint8_t>(bits);
}

/// What pieces have of the surface: walls and open patches.
std::vector<double> surfaceAreas(const CellPieces& content) {
  std::vector<double> areas;
  for (const auto& piece : content.pieces) areas.push_back(piece.area);
  for (const auto& arc : content.arcs) {
    if (arc.isOpenPatch()) areas[arc.below != kNone ? arc.below : arc.above] += arc.area;
  }
  return areas;
}

/// Finds the rows of cells among those of fragments and of pieces.
void noteCells(const TileParts& parts, TileCut& out) {
  const auto& numbers = parts.surface.numbers();
  const auto fragments = parts.surface.fragments();
  const auto& pieces = out.content.pieces;
  const auto areas = surfaceAreas(out.content);
  std::uint32_t piece = 0;
  for (std::size_t first = 0; first < fragments.size();) {
    const auto cell = fragments[first].cell;
    auto last = first + 1;
    while (last < fragments.size() && fragments[last].cell == cell) ++last;
    if (!isWanted(parts.wanted, cell)) {
      first = last;
      continue;
    }
    out.cells.push_back(cell);
    out.firstPiece.push_back(piece);
    out.fluidCorners.push_back(fluidCorners(parts.stretches, numbers.placeOfCell(cell)));
    double fluid = 0;
    double area = 0;
    for (; piece < pieces.size() && pieces[piece].cell == cell; ++piece) {
      fluid += pieces[piece].volume;
      area += areas[piece];
    }
    const auto size = parts.planes.sizeOf(numbers.placeOfCell(cell));
    const double volume = size.x * size.y * size.z;
    const double faceArea = volume / maxComponent(size);
    const auto here = fragments.subspan(first, last - first);
    const bool meets = parts.surface.meetAny(here);
    out.meets.push_back(meets ? 1 : 0);
    const bool isTouched =
        meets ? area <= kSliver * faceArea : touches(parts.surface, here, parts.planes, faceArea);
    if (isTouched) out.isBody[cell] = fluid < 0.5 * volume;
    out.isTouched.push_back(isTouched ? 1 : 0);
    first = last;
  }
  out.firstPiece.push_back(piece);
}

void addArcPolygons(const TileParts& parts, TileCut& out) {
  auto& outlines = out.polygons.arcs;
  const auto& arcs = out.content.arcs;
  while (outlines.count() < arcs.size()) {
    const auto& arc = arcs[outlines.count()];
    const auto face = arc.face;
    if (arc.isOpenPatch()) {
      outlines.add({});
    } else if (parts.faces.isCut(face) && parts.faces.meetsOn(face)) {
      addRegionOutlines(parts.faces, face, outlines);
    } else if (parts.faces.isCut(face)) {
      addOutlines(parts.surface, parts.stretches, parts.faces, parts.planes, face, outlines);
    } else {
      addWholeOutline(parts.surface.numbers(), parts.planes, face, outlines);
    }
  }
}

void addWallPolygons(const TileSurface& surface, TileCut& out) {
  const auto meeting = conformedWalls(surface, out.content, out.polygons.arcs);
  // Piece, patch, fragment or kNone, number of those that meet.
  std::vector<std::array<std::uint32_t, 4>> walls;
  const auto fragments = surface.fragments();
  for (std::uint32_t i = 0; i < fragments.size(); ++i) {
    const auto piece = out.content.ofFragments[i];
    const auto patch = surface.patchOf(fragments[i].triangle);
    if (piece == kNone || patch == kNone) continue;
    if (out.content.isWall(i)) {
      walls.push_back({piece, patch, i, 0});
    } else if (out.content.openArcOf[i] != CellPieces::kNoArea) {
      walls.push_back({piece, WallPolygons::kOfArc + out.content.openArcOf[i], i, 0});
    }
  }
  for (std::uint32_t i = 0; i < meeting.of.size(); ++i) {
    const auto [piece, patch] = meeting.of[i];
    if (patch != kNone) walls.push_back({piece, patch, kNone, i});
  }
  std::ranges::sort(walls);
  for (const auto& [piece, patch, fragment, number] : walls) {
    out.polygons.wallOf.emplace_back(piece, patch);
    out.polygons.fragmentOf.push_back(fragment);
    out.polygons.walls.add(fragment == kNone ? meeting.polygons.of(number)
                                             : surface.points(fragments[fragment]));
  }
}

}  // namespace

TileParts::TileParts(const CutSurface& whole, const TileInput& input)
    : wanted(input.wanted),
      frame(whole.frame()),
      planes(input.planes),
      surface(whole.moved(), whole.patches(), input.triangles, planes, whole.kinds(),
              whole.openKinds()),
      stretches(surface, planes, input.winding, input.windings),
      faces(surface, stretches, planes, wanted) {}

TileCut cutTile(const TileParts& parts, const CutOptions& options) {
  const auto& [wanted, frame, planes, surface, stretches, faces] = parts;
  TileCut result{.numbers = surface.numbers(),
                 .content = findCellPieces(surface, stretches, faces, planes, wanted),
                 .cells = {},
                 .firstPiece = {},
                 .fluidCorners = {},
                 .isTouched = {},
                 .meets = {},
                 .error = {},
                 .isBody = {},
                 .polygons = {},
                 .moments = {},
                 .quadrature = {}};
  noteWallFaces(surface, planes, result.content);
  forTilePlaces(result.numbers.cells(), [&](const TilePlace& cell) {
    result.isBody[result.numbers.cell(cell)] = !parts.stretches.isFluid(cell);
  });
  noteCells(parts, result);
  if (options.polygons || options.quadrature) {
    addArcPolygons(parts, result);
    addWallPolygons(surface, result);
  }
  if (options.moments >= 0) {
    result.moments = findMoments(faces, result.content, frame, options.moments);
  }
  if (options.quadrature) {
    const auto degree = options.quadratureDegree;
    result.quadrature = findQuadrature(result,
                                       degree == options.moments
                                           ? result.moments
                                           : findMoments(faces, result.content, frame, degree),
                                       frame);
    if (!options.polygons) result.polygons = {};
  }
  result.content.meetingWalls = {};
  return result;
}

}  // namespace cutwater
