#include <Cutwater/CutCells/Detail/Leaves/CoarseFace.hpp>
#include <Cutwater/CutCells/Detail/Leaves/HangingCorners.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafPolygons.hpp>
#include <Cutwater/CutCells/Detail/Leaves/WholeLeaves.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceClosing.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceRows.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// In place of a piece: it is dropped, and its arcs with it.
constexpr std::uint32_t kDroppedPiece = CutCells::kNoRow;

/// What is on one side of an arc.
struct ArcSide {
  std::uint32_t leaf = CutLeaves::kNoLeaf;
  std::uint32_t piece = CutCells::kBeyond;
};

/// Where the rows of an arc come from: a source and an arc of its tile, or all of a leaf's face.
struct ArcOrigin {
  std::uint32_t source = kNone;
  std::uint32_t arc = kNone;
};

struct LeafArc {
  std::uint32_t finer = 0;  ///< the leaf whose face it lies in
  int axis = 0;
  bool isHigh = false;       ///< of that leaf's faces across the axis
  std::uint32_t number = 0;  ///< among the arcs of the face
  ArcSide below;
  ArcSide above;
  ArcOrigin origin;

  /// Of its place in the order.
  [[nodiscard]] std::uint64_t key() const {
    const auto face = 2 * static_cast<std::uint64_t>(axis) + (isHigh ? 1 : 0);
    return (std::uint64_t{finer} << 32U) | (face << 29U) | number;
  }
};

/// A face beside a piece that is no arc, because it is a point or leads to a piece that is one.
/// With it, polygons close the piece to the bit.
struct LeafClosing {
  std::uint32_t piece = 0;
  std::uint32_t number = 0;  ///< in the order in which they were found
  ArcOrigin origin;
  bool isAbove = false;  ///< the face is above the piece

  [[nodiscard]] auto key() const { return std::pair(piece, number); }
};

class LeavesAssembly {
 public:
  LeavesAssembly(const LeafParts& parts, std::vector<FluidClass> classes, const CutOptions& options)
      : frame_(parts.frame),
        grid_(parts.grid),
        sources_(parts.tiles, classes.size()),
        polygons_(frame_, grid_, sources_),
        withPolygons_(options.polygons),
        withQuadrature_(options.quadrature),
        gauss_(parts.gauss) {
    out_.classes = std::move(classes);
    out_.patchNames = parts.patchNames;
    out_.moments.degree = options.moments;
  }

  CutLeaves run() {
    addPieces();
    for (std::uint32_t source = 0; source < sources_.all().size(); ++source) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) {
          gatherArcs(source, axis, isHigh);
          gatherOpenPatches(source, axis, isHigh);
          if (withPolygons_) gatherPoints(source, axis, isHigh);
        }
      }
    }
    addArcs();
    sumWholeLeaves(grid_, out_);
    if (withPolygons_) {
      addWallPolygons();
      insertHangingCorners(grid_, out_);
      closePieces(out_);
    }
    return std::move(out_);
  }

 private:
  void addPieces() {
    firstPiece_.assign(sources_.all().size(), CutCells::kWholeCell);
    auto& cut = out_.cut;
    for (std::uint32_t number = 0; number < sources_.all().size(); ++number) {
      if (sources_.isTouched(number)) continue;
      const auto& [leaf, tile, row] = sources_.source(number);
      const auto& from = sources_.tileOf(number).cut;
      const auto outRow = static_cast<std::uint32_t>(cut.leaf.size());
      firstPiece_[number] = pieceCount();
      cut.leaf.push_back(leaf);
      cut.box.push_back(grid_.boxOf(leaf));
      cut.firstPiece.push_back(pieceCount());
      cut.fluidCorners.push_back(from.fluidCorners[row]);
      cut.meets.push_back(from.meets[row]);
      if (!from.error.empty()) cut.error.push_back(from.error[row]);
      cut.wallFaces.push_back(
          wallFacesOf(from.content, from.firstPiece[row], from.firstPiece[row + 1]));
      for (auto p = from.firstPiece[row]; p < from.firstPiece[row + 1]; ++p) {
        addPieceRows(from.content, p, frame_, outRow, out_.pieces, out_.wallParts);
        if (out_.moments.degree >= 0) addPieceMoments(from.moments, p, out_.moments);
        if (withQuadrature_) addPiecePoints(from.quadrature, p, {}, out_.quadrature);
      }
    }
    cut.firstPiece.push_back(pieceCount());
  }
  [[nodiscard]] std::uint32_t pieceCount() const {
    return static_cast<std::uint32_t>(out_.pieces.volume.size());
  }
  /// The row of a piece of a source's tile.
  [[nodiscard]] std::uint32_t rowOf(std::uint32_t source, std::uint32_t piece) const {
    if (piece == kNone) return kDroppedPiece;
    if (firstPiece_[source] == CutCells::kWholeCell) return CutCells::kWholeCell;
    const auto& tile = sources_.tileOf(source);
    return firstPiece_[source] + piece - tile.cut.firstPiece[sources_.source(source).row];
  }

  void gatherArcs(std::uint32_t source, int axis, bool isHigh) {
    const auto leaf = sources_.source(source).leaf;
    const auto [what, other] = grid_.across(leaf, axis, isHigh);
    switch (what) {
      case LeafGrid::Across::Nothing:
        return gatherOwn(source, axis, isHigh, {});
      case LeafGrid::Across::Coarser:  // does it, if the surface meets it
        if (sources_.of(other) != kNone) return;
        return gatherOwn(source, axis, isHigh, {other, CutCells::kWholeCell});
      case LeafGrid::Across::Same:
        if (sources_.of(other) == kNone) {
          return gatherOwn(source, axis, isHigh, {other, CutCells::kWholeCell});
        }
        if (!isHigh) gatherShared(source, sources_.of(other), axis);
        return;
      case LeafGrid::Across::Finer:
        return gatherFiner(source, axis, isHigh);
    }
  }

  /// No leaf is across from them, whatever lies there.
  void gatherOpenPatches(std::uint32_t source, int axis, bool isHigh) {
    const auto& tile = sources_.tileOf(source);
    for (const auto& [face, number] : tile.openArcsOf(sources_.faceOf(source, axis, isHigh))) {
      const auto& arc = tile.cut.content.arcs[number];
      if ((isHigh ? arc.below : arc.above) == kNone) continue;  // that of the leaf across
      const auto own = ownSide(source, number, isHigh);
      gather({source, number}, axis, isHigh, isHigh ? own : ArcSide{}, isHigh ? ArcSide{} : own);
    }
  }

  /// Of a face that the leaf's tile alone knows.
  void gatherOwn(std::uint32_t source, int axis, bool isHigh, const ArcSide& across) {
    const auto& tile = sources_.tileOf(source);
    for (const auto& [face, number] : tile.arcsOf(sources_.faceOf(source, axis, isHigh))) {
      const auto own = ownSide(source, number, isHigh);
      gather({source, number}, axis, isHigh, isHigh ? own : across, isHigh ? across : own);
    }
  }
  /// Of a face between leaves of a level, one in each tile's view.
  void gatherShared(std::uint32_t above, std::uint32_t below, int axis) {
    const auto& tile = sources_.tileOf(above);
    const auto& other = sources_.tileOf(below);
    const auto arcs = tile.arcsOf(sources_.faceOf(above, axis, false));
    const auto others = other.arcsOf(sources_.faceOf(below, axis, true));
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const ArcOrigin origin{above, arcs[i].second};
      const auto ofBelow = ownSide(below, others[i].second, true);
      const auto ofAbove = ownSide(above, arcs[i].second, false);
      if (other.cut.content.arcs[others[i].second].isDropped) {
        note(origin, ofBelow, ofAbove);
      } else {
        gather(origin, axis, false, ofBelow, ofAbove);
      }
    }
  }
  void gatherFiner(std::uint32_t source, int axis, bool isHigh) {
    const CoarseFace face(grid_, sources_, out_.classes, source, axis, isHigh);
    for (const auto& part : face.parts()) {
      const auto coarse = sideOf(source, part.behind);
      const auto finer = sources_.of(part.leaf);
      if (part.arc == kNone) {
        const ArcSide whole{part.leaf, CutCells::kWholeCell};
        gatherWhole(part.leaf, axis, !isHigh, isHigh ? coarse : whole, isHigh ? whole : coarse);
        continue;
      }
      const auto fine = ownSide(finer, part.arc, !isHigh);
      gather({finer, part.arc}, axis, !isHigh, isHigh ? coarse : fine, isHigh ? fine : coarse);
    }
    for (const auto& part : face.points()) {
      noteClosing({sources_.of(part.leaf), part.arc}, rowOf(source, part.behind), isHigh);
    }
  }
  /// Points on a face are no arcs, but may have an outline.
  void gatherPoints(std::uint32_t source, int axis, bool isHigh) {
    const auto face = sources_.faceOf(source, axis, isHigh);
    const auto points = sources_.tileOf(source).pointsOf(face);
    if (points.empty()) return;
    const auto what = grid_.across(sources_.source(source).leaf, axis, isHigh).first;
    if (what == LeafGrid::Across::Finer) return;  // see gatherFiner()
    for (const auto& [its, arc] : points) {
      noteClosing({source, arc}, ownSide(source, arc, isHigh).piece, isHigh);
    }
  }
  [[nodiscard]] ArcSide sideOf(std::uint32_t source, std::uint32_t piece) const {
    return {sources_.source(source).leaf, rowOf(source, piece)};
  }
  /// Of an arc in one of a source's faces, the side of that source.
  [[nodiscard]] ArcSide ownSide(std::uint32_t source, std::uint32_t number, bool isHigh) const {
    const auto& arc = sources_.tileOf(source).cut.content.arcs[number];
    return sideOf(source, isHigh ? arc.below : arc.above);
  }

  void gather(const ArcOrigin& origin, int axis, bool isHigh, const ArcSide& below,
              const ArcSide& above) {
    const auto& arc = sources_.tileOf(origin.source).cut.content.arcs[origin.arc];
    if (arc.isDropped) return note(origin, below, above);
    add({.finer = sources_.source(origin.source).leaf,
         .axis = axis,
         .isHigh = isHigh,
         .below = below,
         .above = above,
         .origin = origin});
  }
  /// All of the face of a leaf that is not cut.
  void gatherWhole(std::uint32_t leaf, int axis, bool isHigh, const ArcSide& below,
                   const ArcSide& above) {
    add({.finer = leaf,
         .axis = axis,
         .isHigh = isHigh,
         .below = below,
         .above = above,
         .origin = {}});
  }
  /// Numbers it, unless it leads to a piece that is dropped, or to none.
  void add(LeafArc arc) {
    const auto pieces = std::array{arc.below.piece, arc.above.piece};
    if (std::ranges::count(pieces, kDroppedPiece) > 0) {
      return note(arc.origin, arc.below, arc.above);
    }
    const bool hasPiece =
        std::ranges::any_of(pieces, [&](std::uint32_t piece) { return piece < pieceCount(); });
    if (!hasPiece) return;
    arc.number = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back(arc);
  }
  /// Notes an open part that counts for nothing.
  void note(const ArcOrigin& origin, const ArcSide& below, const ArcSide& above) {
    noteClosing(origin, below.piece, true);
    noteClosing(origin, above.piece, false);
  }
  void noteClosing(const ArcOrigin& origin, std::uint32_t piece, bool isAbove) {
    if (!withPolygons_ || piece >= pieceCount() || origin.arc == kNone) return;
    closing_.push_back({piece, static_cast<std::uint32_t>(closing_.size()), origin, isAbove});
  }

  void addArcs() {
    for (auto& arc : arcs_) ownByAbove(arc);
    // The arcs of a face were gathered one after the other.
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(arcs_.size());
    for (const auto& arc : arcs_) {
      order.emplace_back(arc.key(), static_cast<std::uint32_t>(order.size()));
    }
    std::ranges::sort(order);
    for (const auto& [key, number] : order) {
      const auto& arc = arcs_[number];
      out_.arcs.below.push_back(arc.below.piece);
      out_.arcs.above.push_back(arc.above.piece);
      out_.arcs.leafBelow.push_back(arc.below.leaf);
      out_.arcs.leafAbove.push_back(arc.above.leaf);
      out_.arcs.axis.push_back(static_cast<std::uint8_t>(arc.axis));
      out_.arcs.faceArea.push_back(grid_.faceArea(arc.finer, arc.axis));
      if (arc.origin.arc == kNone) {
        addWholeArc(arc);
      } else {
        addOpenPart(arc.origin);
      }
    }
  }
  void addOpenPart(const ArcOrigin& origin) {
    const auto& tile = sources_.tileOf(origin.source);
    const auto& arc = tile.cut.content.arcs[origin.arc];
    if (arc.isOpenPatch()) addOpenRow(out_.arcs.area.size(), arc.patch, out_.openArcs);
    out_.arcs.area.push_back(arc.area / (frame_.scale * frame_.scale));
    out_.arcs.centroid.push_back(frame_.toWorld(arc.centroid));
    if (out_.moments.degree >= 0) addArcMoments(tile.cut.moments, origin.arc, out_.moments);
    if (withQuadrature_) addPointRow(tile.cut.quadrature.arc, origin.arc, {}, out_.quadrature.arc);
    if (withPolygons_) out_.arcPolygons.add(polygons_.outlineOf(origin.source, origin.arc));
  }
  void addWholeArc(const LeafArc& arc) {
    const auto box = grid_.boxOf(arc.finer);
    auto centroid = box.center();
    centroid[arc.axis] = arc.isHigh ? box.upper[arc.axis] : box.lower[arc.axis];
    out_.arcs.area.push_back(out_.arcs.faceArea.back());
    out_.arcs.centroid.push_back(centroid);
    const auto moments = momentsOfBox(alongFace(box.lower - centroid, arc.axis),
                                      alongFace(box.upper - centroid, arc.axis));
    const auto count = out_.moments.perArc();
    out_.moments.arc.insert(out_.moments.arc.end(), moments.begin(), moments.begin() + count);
    if (withQuadrature_) addWholeFacePoints(box, centroid, arc.axis);
    if (withPolygons_) {
      out_.arcPolygons.add(polygons_.outlineOfFace(arc.finer, arc.axis, arc.isHigh));
    }
  }

  /// Of the face of a box across an axis, with this center.
  void addWholeFacePoints(const Box<double>& box, const Vec3<double>& center, int axis) {
    auto& rows = out_.quadrature.arc;
    if (rows.first.empty()) rows.first.push_back(0);
    const FaceAxes axes(axis);
    const auto visit = [&](int along, const auto& with) {
      forStretches(gauss_, box.lower[along], std::array{box.upper[along]}, with);
    };
    visit(axes.first, [&](double at, double weight, std::uint32_t) {
      visit(axes.second, [&](double other, double otherWeight, std::uint32_t) {
        auto& point = rows.points.emplace_back(center);
        point[axes.first] = at;
        point[axes.second] = other;
        rows.weights.push_back(weight * otherWeight);
      });
    });
    rows.first.push_back(rows.points.size());
  }

  void addWallPolygons() {
    std::ranges::sort(closing_, {}, &LeafClosing::key);
    const auto& parts = out_.wallParts;
    for (std::size_t part = 0; part < parts.piece.size(); ++part) {
      const auto piece = parts.piece[part];
      const auto source = sources_.of(out_.cut.leaf[out_.pieces.cell[piece]]);
      const auto& tile = sources_.tileOf(source);
      const auto inTile =
          piece - firstPiece_[source] + tile.cut.firstPiece[sources_.source(source).row];
      out_.firstWallPolygon.push_back(out_.wallPolygons.count());
      polygons_.addWall(source, inTile, parts.patch[part], out_.wallPolygons);
      if (part == 0 || parts.piece[part - 1] != piece) addClosing(piece);
    }
    out_.firstWallPolygon.push_back(out_.wallPolygons.count());
  }
  void addClosing(std::uint32_t piece) {
    auto face = std::ranges::lower_bound(closing_, piece, {}, &LeafClosing::piece);
    for (; face != closing_.end() && face->piece == piece; ++face) {
      auto outline = polygons_.outlineOf(face->origin.source, face->origin.arc);
      if (face->isAbove) std::ranges::reverse(outline);  // into the fluid
      if (!outline.empty()) out_.wallPolygons.add(outline);
    }
  }
  /// Of two leaves of a level, the one above counts as the finer one.
  void ownByAbove(LeafArc& arc) const {
    if (!arc.isHigh || arc.above.leaf == CutLeaves::kNoLeaf) return;
    if (grid_.leaves()[arc.above.leaf].level != grid_.leaves()[arc.finer].level) return;
    arc.finer = arc.above.leaf;
    arc.isHigh = false;
  }

  const CutFrame& frame_;
  const LeafGrid& grid_;
  LeafSources sources_;
  LeafPolygons polygons_;
  bool withPolygons_;
  bool withQuadrature_;
  std::span<const GaussPoint> gauss_;
  std::vector<std::uint32_t> firstPiece_;  // of each source; kWholeCell if it is merely touched
  std::vector<LeafArc> arcs_;
  std::vector<LeafClosing> closing_;
  CutLeaves out_;
};

}  // namespace

CutLeaves assembledLeaves(const LeafParts& parts, std::vector<FluidClass> classes,
                          const CutOptions& options) {
  std::vector<OpenMisfit> misfits;
  for (const auto& tile : parts.tiles) {
    const auto& found = tile.cut.content.misfits;
    misfits.insert(misfits.end(), found.begin(), found.end());
  }
  if (!misfits.empty()) refuseMisfits(*parts.surface, misfits);
  return LeavesAssembly(parts, std::move(classes), options).run();
}

}  // namespace cutwater
