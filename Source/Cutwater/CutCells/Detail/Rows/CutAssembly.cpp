#include <Cutwater/CutCells/Detail/Rows/ArcSources.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutAssembly.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceClosing.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceRows.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

/// A cell that is cut: where its rows come from.
struct CellSource {
  std::uint64_t number = 0;  ///< in the grown box; those beyond the box follow all others
  std::uint32_t tile = 0;
  std::uint32_t cell = 0;  ///< row in the tile
};

/// A face beside a piece that is no arc, because it is a point or leads to a piece that is one.
/// With it, polygons close the piece to the bit.
struct ClosingFace {
  std::uint32_t tile = 0;
  std::uint32_t piece = 0;  ///< of the tile
  std::uint32_t arc = 0;    ///< of the tile
  bool isAbove = false;     ///< the face is above the piece

  [[nodiscard]] auto key() const { return std::tuple(tile, piece, arc); }
};

/// Tiles next to each other that are not cut, and are all body or all fluid; or a single one.
struct TileRun {
  std::uint32_t end = 0;  ///< the tile behind the last of them
  bool isBody = false;
};

class Assembly {
 public:
  Assembly(CellPlanes grid, const CutParts& parts, const CutOptions& options)
      : parts_(parts),
        tiles_(parts.tiles),
        cuts_(parts.cuts),
        withPolygons_(options.polygons),
        withQuadrature_(options.quadrature),
        threads_(options.threads) {
    TilePlace cells{};
    for (std::size_t a = 0; a < 3; ++a) cells[a] = static_cast<int>(grid.planes[a].size()) - 3;
    box_ = GrownBox(cells);
    out_.grid = std::move(grid);
    out_.patchNames = parts.patchNames;
    out_.moments.degree = options.moments;
  }

  CutCells run() {
    gatherCells();
    checkMisfits();
    gatherArcs();
    addPieces();
    addArcs();
    addBodyRuns();
    if (withPolygons_) {
      out_.firstWallPolygon.push_back(out_.wallPolygons.count());
      closePieces(out_);
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint64_t kBeyondBit = std::uint64_t{1} << 63U;

  [[nodiscard]] Index3 indexOf(const TilePlace& place) const {
    const auto& first = out_.grid.first;
    return {first.i + place[0] - 1, first.j + place[1] - 1, first.k + place[2] - 1};
  }

  [[nodiscard]] CutFrame frameOf(std::uint32_t tile) const {
    auto frame = parts_.surface != nullptr ? parts_.surface->frame() : CutFrame{};
    frame.shift = tiles_.shiftOf(tile);
    return frame;
  }

  void gatherCells() {
    for (std::uint32_t tile = 0; tile < cuts_.size(); ++tile) {
      if (!cuts_[tile]) continue;
      const auto& cut = *cuts_[tile];
      const auto first = tiles_.firstCell(tile);
      for (std::uint32_t row = 0; row < cut.cells.size(); ++row) {
        if (cut.isTouched[row] != 0) continue;
        const auto place = placeIn(first, cut.numbers.placeOfCell(cut.cells[row]));
        sources_.push_back(
            {box_.numberOf(place) | (box_.isBeyond(place) ? kBeyondBit : 0), tile, row});
      }
    }
    std::ranges::sort(sources_, {}, &CellSource::number);
    const auto beyond = std::ranges::lower_bound(sources_, kBeyondBit, {}, &CellSource::number);
    out_.cellCount = static_cast<std::size_t>(beyond - sources_.begin());
  }

  /// Of open patches. Beyond the box, they are walls.
  void checkMisfits() const {
    std::vector<OpenMisfit> misfits;
    for (std::uint32_t tile = 0; tile < cuts_.size(); ++tile) {
      if (!cuts_[tile]) continue;
      for (const auto& misfit : cuts_[tile]->content.misfits) {
        const auto place =
            placeIn(tiles_.firstCell(tile), cuts_[tile]->numbers.placeOfCell(misfit.cell));
        if (!box_.isBeyond(place)) misfits.push_back(misfit);
      }
    }
    if (!misfits.empty()) refuseMisfits(*parts_.surface, misfits);
  }

  void addPieces() {
    rowsOf_.resize(cuts_.size());
    std::size_t pieces = 0;
    std::size_t walls = 0;
    for (std::size_t tile = 0; tile < cuts_.size(); ++tile) {
      if (!cuts_[tile]) continue;
      const auto& content = cuts_[tile]->content;
      rowsOf_[tile].assign(content.pieces.size(), CutCells::kWholeCell);
      pieces += content.pieces.size();
      walls += content.walls.size();
    }
    reserveRows(sources_.size(), out_.cells);
    reserveRows(pieces, walls, out_.pieces, out_.wallParts);
    for (const auto& source : sources_) {
      const auto& cut = *cuts_[source.tile];
      const auto row = static_cast<std::uint32_t>(out_.cells.index.size());
      out_.cells.index.push_back(indexOf(box_.placeOf(source.number & ~kBeyondBit)));
      out_.cells.firstPiece.push_back(pieceCount());
      out_.cells.fluidCorners.push_back(cut.fluidCorners[source.cell]);
      out_.cells.meets.push_back(cut.meets[source.cell]);
      if (!cut.error.empty()) out_.cells.error.push_back(cut.error[source.cell]);
      out_.cells.wallFaces.push_back(
          wallFacesOf(cut.content, cut.firstPiece[source.cell], cut.firstPiece[source.cell + 1]));
      for (auto p = cut.firstPiece[source.cell]; p < cut.firstPiece[source.cell + 1]; ++p) {
        rowsOf_[source.tile][p] = pieceCount();
        addPiece(source.tile, p, row);
      }
    }
    out_.cells.firstPiece.push_back(pieceCount());
    out_.pieceCount = out_.cells.firstPiece[out_.cellCount];
  }
  [[nodiscard]] std::uint32_t pieceCount() const {
    return static_cast<std::uint32_t>(out_.pieces.volume.size());
  }
  void addPiece(std::uint32_t tile, std::uint32_t number, std::uint32_t row) {
    const auto& content = cuts_[tile]->content;
    if (withPolygons_) {
      const auto walls = wallsOf(content, number);
      for (std::size_t i = 0; i < walls.size(); ++i) {
        addWallPolygons(tile, number, walls[i].patch);
        if (i == 0) addClosingFaces(tile, number);
      }
    }
    addPieceRows(content, number, frameOf(tile), row, out_.pieces, out_.wallParts);
    if (out_.moments.degree >= 0) addPieceMoments(cuts_[tile]->moments, number, out_.moments);
    if (withQuadrature_) addQuadrature(tile, number);
  }

  void addQuadrature(std::uint32_t tile, std::uint32_t piece) {
    addPiecePoints(cuts_[tile]->quadrature, piece, tiles_.shiftOf(tile), out_.quadrature);
  }
  void addWallPolygons(std::uint32_t tile, std::uint32_t piece, std::uint32_t patch) {
    out_.firstWallPolygon.push_back(out_.wallPolygons.count());
    addPolygonsOf(tile, piece, patch, out_.wallPolygons);
  }
  void addPolygonsOf(std::uint32_t tile, std::uint32_t piece, std::uint32_t patch,
                     CutCells::Polygons& to) const {
    const auto& polygons = cuts_[tile]->polygons;
    const auto within = cuts_[tile]->numbers.placeOfCell(cuts_[tile]->content.pieces[piece].cell);
    const auto& of = polygons.wallOf;
    const auto [first, last] = std::equal_range(of.begin(), of.end(), std::pair(piece, patch));
    for (auto wall = first; wall != last; ++wall) {
      const auto number = static_cast<std::size_t>(wall - of.begin());
      addPolygon(tile, within, polygons.walls.of(number), to);
    }
  }
  /// Those of faces that count for nothing, in the first part of a piece's wall.
  void addClosingFaces(std::uint32_t tile, std::uint32_t piece) {
    const auto& cut = *cuts_[tile];
    auto face =
        std::ranges::lower_bound(closing_, std::tuple(tile, piece, 0U), {}, &ClosingFace::key);
    for (; face != closing_.end() && face->tile == tile && face->piece == piece; ++face) {
      const auto outline = cut.polygons.arcs.of(face->arc);
      std::vector<Vec3<double>> polygon(outline.begin(), outline.end());
      if (face->isAbove) std::ranges::reverse(polygon);  // into the fluid
      if (polygon.empty()) continue;
      addPolygon(tile, cut.numbers.placeOfFace(cut.content.arcs[face->arc].face), polygon,
                 out_.wallPolygons);
    }
  }
  /// `within`: a cell of the tile or a face below it, in which the polygon lies.
  void addPolygon(std::uint32_t tile, const TilePlace& within,
                  std::span<const Vec3<double>> polygon, CutCells::Polygons& to) const {
    const auto planes = tiles_.planesOf(tile);
    const auto first = tiles_.firstCell(tile);
    const auto planeOf = [&](int axis, int number) {
      const auto a = asIndex(axis);
      const auto ofBox = asIndex(first[a] + number);
      return std::pair(planes.at(axis, number), out_.grid.planes[a][ofBox]);
    };
    const auto cells = planes.sizes();
    const auto frame = frameOf(tile);
    for (const auto& point : polygon) {
      to.points.push_back(inWorld(point, frame, within, cells, planeOf));
    }
    to.first.push_back(to.points.size());
  }

  /// Finds what the tiles on both sides of a face know, and faces that count for nothing.
  void gatherArcs() {
    arcSources_ = arcSourcesOf(tiles_, cuts_, box_, threads_);
    if (!withPolygons_) return;
    for (std::uint32_t tile = 0; tile < cuts_.size(); ++tile) {
      if (!cuts_[tile]) continue;
      const auto& arcs = cuts_[tile]->content.arcs;
      for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
        if (arcs[arc].isNothing) noteClosing({.tile = tile, .arc = arc});
      }
    }
    for (std::size_t i = 0; i < arcSources_.size(); i += viewsOf(i)) {
      if (!isDropped(i)) continue;
      for (std::size_t n = 0; n < viewsOf(i); ++n) noteClosing(arcSources_[i + n]);
    }
    std::ranges::sort(closing_, {}, &ClosingFace::key);
  }
  /// How many tiles see the arc: two if it lies between them, that below it first.
  [[nodiscard]] std::size_t viewsOf(std::size_t i) const {
    return i + 1 < arcSources_.size() && arcSources_[i + 1].isSame(arcSources_[i]) ? 2 : 1;
  }
  [[nodiscard]] bool isDropped(std::size_t i) const {
    return arcOf(arcSources_[i]).isDropped || arcOf(arcSources_[i + viewsOf(i) - 1]).isDropped;
  }
  void noteClosing(const ArcSource& source) {
    const auto& arc = arcOf(source);
    if (arc.below != kNone) closing_.push_back({source.tile, arc.below, source.arc, true});
    if (arc.above != kNone) closing_.push_back({source.tile, arc.above, source.arc, false});
  }

  void addArcs() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < arcSources_.size(); i += viewsOf(i)) ++count;
    reserveRows(count, out_.arcs);
    for (std::size_t i = 0; i < arcSources_.size(); i += viewsOf(i)) {
      const auto below = rowBeside(arcSources_[i], false);
      const auto above = rowBeside(arcSources_[i + viewsOf(i) - 1], true);
      const auto isOwn = [&](std::uint32_t row) { return row < out_.pieceCount; };
      if (!isDropped(i) && (isOwn(below) || isOwn(above))) addArc(arcSources_[i], below, above);
    }
  }
  [[nodiscard]] const PieceArc& arcOf(const ArcSource& source) const {
    return cuts_[source.tile]->content.arcs[source.arc];
  }
  [[nodiscard]] std::uint32_t rowBeside(const ArcSource& source, bool isAbove) const {
    const auto& arc = arcOf(source);
    const auto piece = isAbove ? arc.above : arc.below;
    if (piece == kNone && arc.isOpenPatch()) return CutCells::kBeyond;
    return piece == kNone ? CutCells::kWholeCell : rowsOf_[source.tile][piece];
  }
  void addArc(const ArcSource& source, std::uint32_t below, std::uint32_t above) {
    const auto frame = frameOf(source.tile);
    const auto& arc = arcOf(source);
    if (arc.isOpenPatch()) addOpenRow(out_.arcs.area.size(), arc.patch, out_.openArcs);
    out_.arcs.below.push_back(below);
    out_.arcs.above.push_back(above);
    out_.arcs.area.push_back(arc.area / (frame.scale * frame.scale));
    out_.arcs.centroid.push_back(frame.toWorld(arc.centroid));
    out_.arcs.cell.push_back(indexOf(box_.placeOf(source.face / 3)));
    out_.arcs.axis.push_back(static_cast<std::uint8_t>(source.face % 3));
    const auto& cut = *cuts_[source.tile];
    if (out_.moments.degree >= 0) addArcMoments(cut.moments, source.arc, out_.moments);
    if (withQuadrature_)
      addPointRow(cut.quadrature.arc, source.arc, frame.shift, out_.quadrature.arc);
    if (!withPolygons_) return;
    if (arc.isOpenPatch()) return addOpenPatch(source);
    addPolygon(source.tile, cut.numbers.placeOfFace(arc.face), cut.polygons.arcs.of(source.arc),
               out_.arcPolygons);
  }
  void addOpenPatch(const ArcSource& source) {
    const auto& arc = arcOf(source);
    const bool isBelow = arc.below != kNone;
    CutCells::Polygons parts;
    addPolygonsOf(source.tile, isBelow ? arc.below : arc.above, WallPolygons::kOfArc + source.arc,
                  parts);
    out_.arcPolygons.add(openOutline(parts, FaceAxes(static_cast<int>(source.face % 3)), isBelow));
  }

  void addBodyRuns() {
    findRuns();
    std::uint64_t next = 0;
    const auto& cells = box_.cells();
    for (int k = 1; k <= cells[2]; ++k) {
      for (int j = 1; j <= cells[1]; ++j) {
        for (int i = 1; i <= cells[0];) {
          const auto row = tiles_.rowFrom({i, j, k});
          const int end = std::min(row.end, cells[0] + 1);
          addBodyRuns(row, end - i, next);
          i = end;
        }
      }
    }
  }
  void findRuns() {
    const auto count = static_cast<std::uint32_t>(cuts_.size());
    tileRuns_.resize(count);
    for (std::uint32_t tile = count; tile-- > 0;) {
      auto& run = tileRuns_[tile];
      run = {tile + 1, parts_.isBody(tile)};
      if (tile + 1 == count || cuts_[tile] || cuts_[tile + 1]) continue;
      if (tileRuns_[tile + 1].isBody == run.isBody) run.end = tileRuns_[tile + 1].end;
    }
  }
  /// Of `count` cells, from the first in a row of tiles on.
  void addBodyRuns(const CutBlocks::Row& row, int count, std::uint64_t& next) {
    auto [tile, within, end] = row;
    while (count > 0) {
      const auto& run = tileRuns_[tile];
      const auto alike = static_cast<std::int64_t>(run.end - tile) * CutTiles::kWidth - within[0];
      const auto cells = static_cast<int>(std::min<std::int64_t>(alike, count));
      count -= cells;
      if (cuts_[tile]) {
        const auto& cut = *cuts_[tile];
        for (int n = 0; n < cells; ++n, ++within[0]) {
          addRun(next, 1, cut.isBody[cut.numbers.cell(within)]);
        }
      } else {
        addRun(next, cells, run.isBody);
      }
      tile = run.end;
      within[0] = 0;
    }
  }
  void addRun(std::uint64_t& next, int count, bool isBody) {
    const auto first = next;
    next += static_cast<std::uint64_t>(count);
    if (!isBody) return;
    if (!out_.bodyRuns.empty() && out_.bodyRuns.back()[1] == first) {
      out_.bodyRuns.back()[1] = next;
    } else {
      out_.bodyRuns.push_back({first, next});
    }
  }

  const CutParts& parts_;
  const CutBlocks& tiles_;
  std::span<const std::unique_ptr<const TileCut>> cuts_;
  bool withPolygons_;
  bool withQuadrature_;
  int threads_;
  GrownBox box_{{}};
  std::vector<CellSource> sources_;
  std::vector<ArcSource> arcSources_;
  std::vector<ClosingFace> closing_;
  std::vector<std::vector<std::uint32_t>> rowsOf_;  // of pieces, per tile
  std::vector<TileRun> tileRuns_;                   // from each tile on
  CutCells out_;
};

}  // namespace

CutCells assembledCells(CellPlanes grid, const CutParts& parts, const CutOptions& options) {
  return Assembly(std::move(grid), parts, options).run();
}

}  // namespace cutwater
