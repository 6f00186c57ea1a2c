#include <Cutwater/CutCells/Detail/Pieces/OpenArcs.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallFaces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/OpenSides.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PlaneCut.hpp>
#include <Cutwater/CutCells/Detail/Tiles/RectanglePieces.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace cutwater {

namespace {

/// In perimeters of the rectangle: what is shorter is a point, but for rounding.
constexpr double kPoint = 1e-14;

/// Turns open parts of the faces between two layers into pieces of cells, and stretches of their
/// edges into arcs.
class PlaneCutter {
 public:
  PlaneCutter(const TileSurface& surface, const EdgeStretches& stretches, const FacePieces& faces,
              const GridPlanes& planes, double thickness)
      : surface_(surface),
        stretches_(stretches),
        faces_(faces),
        planes_(planes),
        thickness_(thickness),
        sides_(surface, stretches, planes),
        rowOf_(faces.pieces().size(), kNone) {}

  TileCut run() {
    out_.numbers = surface_.numbers();
    const auto& cells = out_.numbers.cells();
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) addCell({i, j, 1});
    }
    out_.firstPiece.push_back(pieceCount());
    for (const auto& [key, wall] : walls_) {
      if (wall.area > 0) out_.content.walls.push_back(meanOf(wall));
    }
    for (const int axis : {0, 1}) {
      for (int j = 0; j < cells[1] + axis; ++j) {
        for (int i = 0; i < cells[0] + 1 - axis; ++i) addArcs(axis, {i, j, 1});
      }
    }
    addOpenArcs();
    return std::move(out_);
  }

 private:
  /// Of a rectangle.
  struct Side {
    int axis = -1;  ///< -1: none
    bool isHigh = false;

    [[nodiscard]] std::uint8_t bit() const { return axis < 0 ? 0 : bitOfFace(axis, isHigh); }
  };

  [[nodiscard]] std::uint32_t pieceCount() const {
    return static_cast<std::uint32_t>(out_.content.pieces.size());
  }
  [[nodiscard]] std::uint32_t faceOf(const TilePlace& cell) const {
    return out_.numbers.face(2, cell);
  }
  [[nodiscard]] std::span<const EdgeStretch> stretchesOf(const TilePlace& cell, int side) const {
    const auto edge = edgeOfFace(2, cell, side);
    return stretches_.of(edge.axis, edge.place);
  }

  void addCell(const TilePlace& place) {
    const auto cell = out_.numbers.cell(place);
    const auto face = faceOf(place);
    out_.isBody[cell] = !stretches_.isFluid(place);
    if (!faces_.isCut(face)) return;
    const auto size = planes_.sizeOf(place);
    const double least = kPoint * 2 * (size.x + size.y);
    out_.cells.push_back(cell);
    out_.firstPiece.push_back(pieceCount());
    out_.fluidCorners.push_back(fluidCorners(place));
    const bool meets = faces_.meetsOn(face);
    double fluid = 0;
    bool isTouched = true;
    if (meets) {
      noteMisfits(cell, face);
      const double sliver = kSliver * (size.x + size.y);
      isTouched = addMeetingPieces(place, sliver) <= sliver;
      for (auto p = out_.firstPiece.back(); p < pieceCount(); ++p) {
        fluid += out_.content.pieces[p].volume / thickness_;
      }
    } else {
      fluid = addPieces(place, least);
      const auto [first, last] = faces_.tracesOf(face);
      for (auto trace = first; trace < last; ++trace) {
        isTouched = isTouched && lengthOf(trace) <= least;
        addWall(trace);
      }
    }
    if (isTouched) out_.isBody[cell] = fluid < 0.5 * size.x * size.y;
    out_.isTouched.push_back(isTouched ? 1 : 0);
    out_.meets.push_back(meets ? 1 : 0);
    finishWalls(out_.firstPiece.back());
    closesByArcs_.resize(pieceCount(), meets ? 1 : 0);
    if (!meets) return;
    for (auto p = out_.firstPiece.back(); p < pieceCount(); ++p) {
      out_.content.pieces[p].areaVector = {};  // see close()
    }
  }
  void addPiece(const TilePlace& place, const FacePiece& piece) {
    out_.content.pieces.push_back({.cell = out_.numbers.cell(place),
                                   .volume = piece.area * thickness_,
                                   .centroid = piece.centroid,
                                   .areaVector = {},
                                   .wallCentroid = {}});
  }
  /// Where triangles meet: those of open patches that lie in no side.
  void noteMisfits(std::uint32_t cell, std::uint32_t face) {
    const auto [first, last] = faces_.tracesOf(face);
    for (auto trace = first; trace < last; ++trace) {
      const auto& t = surface_.traces()[trace];
      const auto [isOpen, axis, isHigh] =
          openFaceOf(surface_, planes_, {.cell = cell, .triangle = t.triangle});
      if (!isOpen || axis == 0 || axis == 1 || t.from == t.to) continue;
      out_.content.misfits.push_back({t.triangle, cell, t.from});
    }
  }
  /// Patches that are open and have traces on a face.
  [[nodiscard]] std::vector<std::uint32_t> openPatchesOn(std::uint32_t face) const {
    std::vector<std::uint32_t> patches;
    const auto [first, last] = faces_.tracesOf(face);
    for (auto trace = first; trace < last; ++trace) {
      const auto triangle = surface_.traces()[trace].triangle;
      if (surface_.openKindOf(triangle) == OpenKind::Wall) continue;
      patches.push_back(surface_.patchOf(triangle));
    }
    return patches;
  }
  /// Returns how long their walls are. `least`: openings that are shorter are rounding.
  double addMeetingPieces(const TilePlace& place, double least) {
    RectanglePieces found(faces_, sides_, faceOf(place));
    const auto first = pieceCount();
    for (const auto& piece : found.pieces) addPiece(place, piece);
    const auto sides = sidesWithTraces(place);
    const auto open = openPatchesOn(faceOf(place));
    double sum = 0;
    for (auto wall : found.walls) {
      sum += length(wall.to - wall.from);
      wall.part += first;
      const auto side = sideOf(wall, place);
      if ((side.bit() & sides) != 0 && std::ranges::count(open, wall.patch) > 0) {
        if (length(wall.to - wall.from) <= least) continue;
        open_.addMeeting(openArc(wall, side.axis, side.isHigh));
        continue;
      }
      addWall(wall.part, wall.patch, wall.from, wall.to);
      out_.content.pieces[wall.part].wallFaces |= static_cast<std::uint8_t>(side.bit() & sides);
    }
    for (auto& side : found.ofStretches) {
      for (auto& piece : side) piece += piece == kNone ? 0 : first;
    }
    rowsOfStretches_[faceOf(place)] = std::move(found.ofStretches);
    return sum;
  }
  /// Returns their area.
  double addPieces(const TilePlace& place, double least) {
    const auto [first, last] = faces_.of(faceOf(place));
    const auto rims = rimsOf(place);
    double sum = 0;
    for (auto n = first; n < last; ++n) {
      const auto& piece = faces_.pieces()[n];
      if (piece.isNothing || rims[n - first] <= least) continue;
      rowOf_[n] = pieceCount();
      addPiece(place, piece);
      sum += piece.area;
    }
    return sum;
  }
  /// The lengths of the rims of a cut face's open parts.
  [[nodiscard]] std::vector<double> rimsOf(const TilePlace& place) const {
    const auto face = faceOf(place);
    const auto [first, last] = faces_.of(face);
    std::vector<double> rims(last - first);
    const auto [firstTrace, lastTrace] = faces_.tracesOf(face);
    for (auto trace = firstTrace; trace < lastTrace; ++trace) {
      const auto piece = faces_.ofTrace(trace);
      if (piece != kNone) rims[piece - first] += lengthOf(trace);
    }
    for (int side = 0; side < 4; ++side) {
      const auto stretches = stretchesOf(place, side);
      for (std::size_t s = 0; s < stretches.size(); ++s) {
        rims[faces_.ofStretch(face, side, s) - first] += stretches[s].length();
      }
    }
    return rims;
  }
  [[nodiscard]] double lengthOf(std::uint32_t trace) const {
    const auto& t = surface_.traces()[trace];
    return length(t.to - t.from);
  }
  [[nodiscard]] std::uint8_t fluidCorners(const TilePlace& place) const {
    unsigned bits = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const TilePlace node{place[0] + corner % 2, place[1] + corner / 2, 1};
      if (stretches_.isFluid(node)) bits |= 0x11U << static_cast<unsigned>(corner);
    }
    return static_cast<std::uint8_t>(bits);
  }

  /// A wall is as long as the trace, and as high as the cell.
  void addWall(std::uint32_t trace) {
    const auto open = faces_.ofTrace(trace);
    const auto piece = open == kNone ? kNone : rowOf_[open];
    const auto& t = surface_.traces()[trace];
    if (piece == kNone || takeOpen(trace, piece)) return;
    auto& found = out_.content.pieces[piece];
    found.wallFaces |= sideOf(trace, found.cell);
    addWall(piece, surface_.patchOf(t.triangle), t.from, t.to);
  }
  /// The side of a rectangle in which a trace lies, as a bit; 0 if it does in none.
  [[nodiscard]] std::uint8_t sideOf(std::uint32_t trace, std::uint32_t cell) const {
    const auto triangle = surface_.traces()[trace].triangle;
    if (surface_.patchOf(triangle) == kNone) return 0;
    return wallSideOf(surface_, planes_, out_.numbers.placeOfCell(cell), triangle,
                      planes_.at(2, 1));
  }
  [[nodiscard]] std::uint8_t sidesWithTraces(const TilePlace& place) const {
    std::uint8_t sides = 0;
    const auto [first, last] = faces_.tracesOf(faceOf(place));
    for (auto trace = first; trace < last; ++trace) {
      sides |= sideOf(trace, out_.numbers.cell(place));
    }
    return sides;
  }
  /// The same for a wall where triangles meet, by its ends.
  [[nodiscard]] Side sideOf(const FaceRegions::Wall& wall, const TilePlace& place) const {
    for (const int axis : {0, 1}) {
      for (const bool isHigh : {false, true}) {
        const double plane = planes_.at(axis, place[asIndex(axis)] + (isHigh ? 1 : 0));
        if (wall.from[axis] == plane && wall.to[axis] == plane) return {axis, isHigh};
      }
    }
    return {};
  }
  void addWall(std::uint32_t piece, std::uint32_t patch, const Vec3<double>& from,
               const Vec3<double>& to) {
    if (patch == kNone) return;
    auto& wall = walls_[{piece, patch}];
    wall.piece = piece;
    wall.patch = patch;
    const auto way = to - from;
    const double area = length(way) * thickness_;
    wall.area += area;
    wall.areaVector += thickness_ * Vec3<double>{way.y, -way.x, 0};
    wall.centroid += area * 0.5 * (from + to);
  }
  /// Whether a trace is one of an open patch, in a side of the piece's cell.
  bool takeOpen(std::uint32_t trace, std::uint32_t piece) {
    const auto& t = surface_.traces()[trace];
    const auto cell = out_.content.pieces[piece].cell;
    const auto [isOpen, axis, isHigh] =
        openFaceOf(surface_, planes_, {.cell = cell, .triangle = t.triangle});
    if (!isOpen) return false;
    if (axis != 0 && axis != 1) {
      out_.content.misfits.push_back({t.triangle, cell, t.from});
      return false;
    }
    open_.addTrace(t, openArc({piece, surface_.patchOf(t.triangle), t.from, t.to}, axis, isHigh));
    return true;
  }
  /// `part`: of a piece's side.
  [[nodiscard]] PieceArc openArc(const FaceRegions::Wall& part, int axis, bool isHigh) const {
    auto place = out_.numbers.placeOfCell(out_.content.pieces[part.part].cell);
    place[asIndex(axis)] += isHigh ? 1 : 0;
    PieceArc arc{.face = out_.numbers.face(axis, place),
                 .area = length(part.to - part.from) * thickness_,
                 .centroid = 0.5 * (part.from + part.to),
                 .patch = part.patch};
    (isHigh ? arc.below : arc.above) = part.part;
    return arc;
  }
  static PieceWall meanOf(PieceWall wall) {
    wall.centroid = wall.centroid / wall.area;
    return wall;
  }
  /// Sums up the walls of the pieces from this one on.
  void finishWalls(std::uint32_t first) {
    auto& pieces = out_.content.pieces;
    for (auto it = walls_.lower_bound({first, 0}); it != walls_.end(); ++it) {
      const auto& wall = it->second;
      auto& piece = pieces[wall.piece];
      piece.area += wall.area;
      piece.areaVector += wall.areaVector;
      piece.wallCentroid += wall.centroid;
    }
    for (auto p = first; p < pieceCount(); ++p) {
      auto& piece = pieces[p];
      piece.wallCentroid = piece.area > 0 ? piece.wallCentroid / piece.area : piece.centroid;
    }
  }

  /// What is open between two rectangles: the stretches of the edge that begins there.
  void addArcs(int axis, const TilePlace& place) {
    auto below = place;
    --below[asIndex(axis)];
    // Sides of rectangles, see FacePieces::ofStretch().
    const int highSide = axis == 0 ? 3 : 1;
    const int lowSide = axis == 0 ? 2 : 0;
    const auto stretches = sides_.of(1 - axis, place);
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      PieceArc arc{.face = out_.numbers.face(axis, place), .centroid = {}};
      const bool isCutBelow = setPiece(below, highSide, s, arc.below, arc);
      const bool isCutAbove = setPiece(place, lowSide, s, arc.above, arc);
      if (!isCutBelow && !isCutAbove) continue;
      arc.area = stretches[s].length() * thickness_;
      arc.centroid[axis] = planes_.at(axis, place[asIndex(axis)]);
      arc.centroid[1 - axis] = stretches[s].middle();
      arc.centroid.z = planes_.at(2, 1);
      close(arc.below, axis, -arc.area);
      close(arc.above, axis, arc.area);
      out_.content.arcs.push_back(arc);
    }
  }
  /// Where triangles meet, the wall's vector is what closes the open parts.
  void close(std::uint32_t number, int axis, double area) {
    if (number == kNone || closesByArcs_[number] == 0) return;
    out_.content.pieces[number].areaVector[axis] += area;
  }
  /// Finds the piece of a cell beside an arc; returns whether the cell is in the tile and cut.
  bool setPiece(const TilePlace& cell, int side, std::size_t stretch, std::uint32_t& piece,
                PieceArc& arc) const {
    const auto& cells = out_.numbers.cells();
    if (cell[0] < 0 || cell[1] < 0 || cell[0] >= cells[0] || cell[1] >= cells[1]) return false;
    const auto face = faceOf(cell);
    if (!faces_.isCut(face)) return false;
    piece = faces_.meetsOn(face)
                ? rowsOfStretches_.at(face)[static_cast<std::size_t>(side)][stretch]
                : rowOf_[faces_.ofStretch(face, side, stretch)];
    arc.isDropped = arc.isDropped || piece == kNone;
    return true;
  }

  void addOpenArcs() {
    for (const auto& arc : open_.arcs()) {
      const int axis = out_.numbers.axisOfFace(arc.face);
      close(arc.below, axis, -arc.area);
      close(arc.above, axis, arc.area);
      out_.content.arcs.push_back(arc);
    }
  }

  const TileSurface& surface_;
  const EdgeStretches& stretches_;
  const FacePieces& faces_;
  const GridPlanes& planes_;
  double thickness_;
  SideStretches sides_;
  std::vector<std::uint32_t> rowOf_;  // the piece of each open part, or kNone
  /// On faces where triangles meet: the piece of each stretch of each side, or kNone.
  std::map<std::uint32_t, std::array<std::vector<std::uint32_t>, 4>> rowsOfStretches_;
  std::vector<char> closesByArcs_;  // of pieces: where triangles meet
  /// By piece and patch; centroids are integrals.
  std::map<std::pair<std::uint32_t, std::uint32_t>, PieceWall> walls_;
  OpenSides open_;
  TileCut out_;
};

}  // namespace

std::array<double, 3> planesAround(double z) {
  // How far away the others are does not matter: only what lies in the plane is used.
  const double gap = 0x1p-20 * std::max(1.0, std::abs(z));
  return {z - gap, z, z + gap};
}

TileCut cutTileInPlane(const CutSurface& surface, const CutBlocks& tiles, std::size_t tile,
                       double thickness) {
  const TileParts parts(surface, tiles.input(tile));
  return PlaneCutter(parts.surface, parts.stretches, parts.faces, parts.planes, thickness).run();
}

}  // namespace cutwater
