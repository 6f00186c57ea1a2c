#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/CutCells/Detail/CoarseFace.hpp>
#include <Cutwater/CutCells/Detail/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/PieceRows.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

/// In place of a piece: it is dropped, and its arcs with it.
constexpr std::uint32_t kDroppedPiece = CutCells::kNoRow;

/// What is on one side of an arc.
struct ArcSide {
  std::uint32_t leaf = CutLeaves::kNoLeaf;
  std::uint32_t piece = CutCells::kBeyond;
};

struct LeafArc {
  std::uint32_t finer = 0;  ///< the leaf whose face it lies in
  int axis = 0;
  bool isHigh = false;       ///< of that leaf's faces across the axis
  std::uint32_t number = 0;  ///< among the arcs of the face
  ArcSide below;
  ArcSide above;
  double area = 0;
  Vec3<double> centroid;

  [[nodiscard]] auto key() const { return std::tuple(finer, axis, isHigh, number); }
};

class LeavesAssembly {
 public:
  LeavesAssembly(const CutSurface& surface, const LeafGrid& grid, std::span<const LeafTile> tiles,
                 std::vector<FluidClass> classes)
      : frame_(surface.frame()), grid_(grid), sources_(tiles, classes.size()) {
    out_.classes = std::move(classes);
    out_.patchNames = surface.patchNames();
  }

  CutLeaves run() {
    addPieces();
    for (std::uint32_t source = 0; source < sources_.all().size(); ++source) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) gatherArcs(source, axis, isHigh);
      }
    }
    addArcs();
    addWholeLeaves();
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
      for (auto p = from.firstPiece[row]; p < from.firstPiece[row + 1]; ++p) {
        addPieceRows(from.content, p, frame_, outRow, out_.pieces, out_.wallParts);
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

  /// Of a face that the leaf's tile alone knows.
  void gatherOwn(std::uint32_t source, int axis, bool isHigh, const ArcSide& across) {
    const auto& tile = sources_.tileOf(source);
    for (const auto& [face, number] : tile.arcsOf(sources_.faceOf(source, axis, isHigh))) {
      const auto& arc = tile.cut.content.arcs[number];
      const ArcSide own = sideOf(source, isHigh ? arc.below : arc.above);
      gather(source, axis, isHigh, arc, isHigh ? own : across, isHigh ? across : own);
    }
  }
  /// Of a face between leaves of a level, one in each tile's view.
  void gatherShared(std::uint32_t above, std::uint32_t below, int axis) {
    const auto& tile = sources_.tileOf(above);
    const auto& other = sources_.tileOf(below);
    const auto arcs = tile.arcsOf(sources_.faceOf(above, axis, false));
    const auto others = other.arcsOf(sources_.faceOf(below, axis, true));
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const auto& arc = tile.cut.content.arcs[arcs[i].second];
      const auto& same = other.cut.content.arcs[others[i].second];
      if (same.isDropped) continue;
      gather(above, axis, false, arc, sideOf(below, same.below), sideOf(above, arc.above));
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
      const auto& arc = sources_.tileOf(finer).cut.content.arcs[part.arc];
      const auto fine = sideOf(finer, isHigh ? arc.above : arc.below);
      gather(finer, axis, !isHigh, arc, isHigh ? coarse : fine, isHigh ? fine : coarse);
    }
  }
  [[nodiscard]] ArcSide sideOf(std::uint32_t source, std::uint32_t piece) const {
    return {sources_.source(source).leaf, rowOf(source, piece)};
  }

  void gather(std::uint32_t finer, int axis, bool isHigh, const PieceArc& arc, const ArcSide& below,
              const ArcSide& above) {
    if (arc.isDropped) return;
    add({.finer = sources_.source(finer).leaf,
         .axis = axis,
         .isHigh = isHigh,
         .below = below,
         .above = above,
         .area = arc.area / (frame_.scale * frame_.scale),
         .centroid = frame_.toWorld(arc.centroid)});
  }
  /// All of the face of a leaf that is not cut.
  void gatherWhole(std::uint32_t leaf, int axis, bool isHigh, const ArcSide& below,
                   const ArcSide& above) {
    const auto box = grid_.boxOf(leaf);
    auto centroid = box.center();
    centroid[axis] = isHigh ? box.upper[axis] : box.lower[axis];
    add({.finer = leaf,
         .axis = axis,
         .isHigh = isHigh,
         .below = below,
         .above = above,
         .area = grid_.faceArea(leaf, axis),
         .centroid = centroid});
  }
  /// Numbers it, unless it leads to a piece that is dropped, or to none.
  void add(LeafArc arc) {
    const auto pieces = std::array{arc.below.piece, arc.above.piece};
    const bool isDropped = std::ranges::count(pieces, kDroppedPiece) > 0;
    const bool hasPiece =
        std::ranges::any_of(pieces, [&](std::uint32_t piece) { return piece < pieceCount(); });
    if (isDropped || !hasPiece) return;
    arc.number = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back(arc);
  }

  void addArcs() {
    for (auto& arc : arcs_) ownByAbove(arc);
    // The arcs of a face were gathered one after the other.
    std::ranges::sort(arcs_, {}, &LeafArc::key);
    for (const auto& arc : arcs_) {
      out_.arcs.below.push_back(arc.below.piece);
      out_.arcs.above.push_back(arc.above.piece);
      out_.arcs.leafBelow.push_back(arc.below.leaf);
      out_.arcs.leafAbove.push_back(arc.above.leaf);
      out_.arcs.area.push_back(arc.area);
      out_.arcs.centroid.push_back(arc.centroid);
      out_.arcs.axis.push_back(static_cast<std::uint8_t>(arc.axis));
      out_.arcs.faceArea.push_back(grid_.faceArea(arc.finer, arc.axis));
    }
  }
  /// Of two leaves of a level, the one above counts as the finer one.
  void ownByAbove(LeafArc& arc) const {
    if (!arc.isHigh || arc.above.leaf == CutLeaves::kNoLeaf) return;
    if (grid_.leaves()[arc.above.leaf].level != grid_.leaves()[arc.finer].level) return;
    arc.finer = arc.above.leaf;
    arc.isHigh = false;
  }

  void addWholeLeaves() {
    DoubleDouble fluid;
    DoubleDouble body;
    for (std::uint32_t leaf = 0; leaf < out_.classes.size(); ++leaf) {
      if (out_.classes[leaf] == FluidClass::Fluid) fluid += grid_.volume(leaf);
      if (out_.classes[leaf] == FluidClass::Body) body += grid_.volume(leaf);
    }
    out_.wholeFluid = static_cast<double>(fluid);
    out_.wholeBody = static_cast<double>(body);
  }

  const CutFrame& frame_;
  const LeafGrid& grid_;
  LeafSources sources_;
  std::vector<std::uint32_t> firstPiece_;  // of each source; kWholeCell if it is merely touched
  std::vector<LeafArc> arcs_;
  CutLeaves out_;
};

}  // namespace

CutLeaves assembledLeaves(const CutSurface& surface, const LeafGrid& grid,
                          std::span<const LeafTile> tiles, std::vector<FluidClass> classes) {
  return LeavesAssembly(surface, grid, tiles, std::move(classes)).run();
}

}  // namespace cutwater
