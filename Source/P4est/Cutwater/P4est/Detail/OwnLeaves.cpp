#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/P4est/Detail/OwnLeaves.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// Takes the rows of some leaves out of those of a part of an octree.
class OwnLeaves {
 public:
  OwnLeaves(const CutLeaves& part, std::uint32_t first, std::uint32_t count,
            std::span<const std::uint64_t> numbers)
      : part_(part), first_(first), count_(count), numbers_(numbers) {
    const auto& leaf = part.cut.leaf;
    firstRow_ = rowFrom(first);
    lastRow_ = rowFrom(first + count);
    firstPiece_ = leaf.empty() ? 0 : part.cut.firstPiece[firstRow_];
    lastPiece_ = leaf.empty() ? 0 : part.cut.firstPiece[lastRow_];
    auto& out = out_.leaves;
    out.patchNames = part.patchNames;
    out.moments.degree = part.moments.degree;
    hasPolygons_ = !part.firstWallPolygon.empty();
  }

  DistributedCut run(std::span<const double> volumes) {
    takeRows();
    takePieces();
    takeWalls();
    for (std::size_t arc = 0; arc < part_.arcs.area.size(); ++arc) takeArc(arc);
    takeClasses(volumes);
    return std::move(out_);
  }

 private:
  template <typename Value>
  static void take(const std::vector<Value>& from, std::size_t first, std::size_t last,
                   std::vector<Value>& to) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
              from.begin() + static_cast<std::ptrdiff_t>(last));
  }

  [[nodiscard]] std::uint32_t rowFrom(std::uint32_t leaf) const {
    const auto& leaves = part_.cut.leaf;
    return static_cast<std::uint32_t>(std::ranges::lower_bound(leaves, leaf) - leaves.begin());
  }
  [[nodiscard]] bool isOwn(std::uint32_t piece) const {
    return piece >= firstPiece_ && piece < lastPiece_;
  }

  void takeRows() {
    auto& to = out_.leaves.cut;
    const auto& from = part_.cut;
    take(from.leaf, firstRow_, lastRow_, to.leaf);
    for (auto& leaf : to.leaf) leaf -= first_;
    take(from.box, firstRow_, lastRow_, to.box);
    take(from.fluidCorners, firstRow_, lastRow_, to.fluidCorners);
    take(from.meets, firstRow_, lastRow_, to.meets);
    take(from.wallFaces, firstRow_, lastRow_, to.wallFaces);
    if (from.firstPiece.empty()) return;
    take(from.firstPiece, firstRow_, lastRow_ + 1, to.firstPiece);
    for (auto& piece : to.firstPiece) piece -= firstPiece_;
  }
  void takePieces() {
    auto& to = out_.leaves.pieces;
    const auto& from = part_.pieces;
    take(from.cell, firstPiece_, lastPiece_, to.cell);
    for (auto& row : to.cell) row -= firstRow_;
    take(from.volume, firstPiece_, lastPiece_, to.volume);
    take(from.centroid, firstPiece_, lastPiece_, to.centroid);
    take(from.wallArea, firstPiece_, lastPiece_, to.wallArea);
    take(from.wallVector, firstPiece_, lastPiece_, to.wallVector);
    take(from.wallCentroid, firstPiece_, lastPiece_, to.wallCentroid);
    take(from.wallFaces, firstPiece_, lastPiece_, to.wallFaces);
    const auto per = part_.moments.perPiece();
    auto& moments = out_.leaves.moments;
    take(part_.moments.volume, per * firstPiece_, per * lastPiece_, moments.volume);
    take(part_.moments.wall, per * firstPiece_, per * lastPiece_, moments.wall);
    take(part_.moments.wallVector, per * firstPiece_, per * lastPiece_, moments.wallVector);
  }
  void takeWalls() {
    const auto& from = part_.wallParts;
    auto& to = out_.leaves;
    for (std::size_t wall = 0; wall < from.piece.size(); ++wall) {
      if (!isOwn(from.piece[wall])) continue;
      to.wallParts.piece.push_back(from.piece[wall] - firstPiece_);
      to.wallParts.patch.push_back(from.patch[wall]);
      to.wallParts.area.push_back(from.area[wall]);
      to.wallParts.vector.push_back(from.vector[wall]);
      to.wallParts.centroid.push_back(from.centroid[wall]);
      if (!hasPolygons_) continue;
      to.firstWallPolygon.push_back(to.wallPolygons.count());
      for (auto n = part_.firstWallPolygon[wall]; n < part_.firstWallPolygon[wall + 1]; ++n) {
        to.wallPolygons.add(part_.wallPolygons.of(n));
      }
    }
    if (hasPolygons_) to.firstWallPolygon.push_back(to.wallPolygons.count());
  }

  void takeArc(std::size_t arc) {
    const auto& from = part_.arcs;
    if (!isOwn(from.below[arc]) && !isOwn(from.above[arc])) return;
    auto& to = out_.leaves;
    const auto patch = part_.openArcs.patchOf(static_cast<std::uint32_t>(arc));
    if (patch != CutCells::kNoRow) {
      to.openArcs.arc.push_back(static_cast<std::uint32_t>(to.arcs.area.size()));
      to.openArcs.patch.push_back(patch);
    }
    takeSide(from.leafBelow[arc], from.below[arc], to.arcs.leafBelow, to.arcs.below);
    takeSide(from.leafAbove[arc], from.above[arc], to.arcs.leafAbove, to.arcs.above);
    to.arcs.area.push_back(from.area[arc]);
    to.arcs.centroid.push_back(from.centroid[arc]);
    to.arcs.faceArea.push_back(from.faceArea[arc]);
    to.arcs.axis.push_back(from.axis[arc]);
    const auto per = part_.moments.perArc();
    take(part_.moments.arc, per * arc, per * (arc + 1), to.moments.arc);
    if (hasPolygons_) to.arcPolygons.add(part_.arcPolygons.of(arc));
  }
  /// One side of an arc; beyond the rank's leaves, notes what is there.
  void takeSide(std::uint32_t leaf, std::uint32_t piece, std::vector<std::uint32_t>& leaves,
                std::vector<std::uint32_t>& pieces) {
    const bool isOwnLeaf = leaf >= first_ && leaf - first_ < count_;
    if (isOwnLeaf || leaf == CutLeaves::kNoLeaf) {
      leaves.push_back(isOwnLeaf ? leaf - first_ : leaf);
      pieces.push_back(isOwn(piece) ? piece - firstPiece_ : piece);
      return;
    }
    const auto arc = static_cast<std::uint32_t>(leaves.size());
    leaves.push_back(CutLeaves::kNoLeaf);
    pieces.push_back(CutLeaves::kBeyond);
    if (piece < part_.pieces.cell.size()) piece -= part_.cut.firstPiece[part_.pieces.cell[piece]];
    out_.rims.push_back({arc, numbers_[leaf], piece});
  }

  void takeClasses(std::span<const double> volumes) {
    take(part_.classes, first_, first_ + count_, out_.leaves.classes);
    DoubleDouble fluid;
    DoubleDouble body;
    for (std::size_t leaf = 0; leaf < count_; ++leaf) {
      if (out_.leaves.classes[leaf] == FluidClass::Fluid) fluid += volumes[leaf];
      if (out_.leaves.classes[leaf] == FluidClass::Body) body += volumes[leaf];
    }
    out_.leaves.wholeFluid = static_cast<double>(fluid);
    out_.leaves.wholeBody = static_cast<double>(body);
  }

  const CutLeaves& part_;
  std::uint32_t first_;
  std::uint32_t count_;
  std::span<const std::uint64_t> numbers_;
  std::uint32_t firstRow_ = 0;
  std::uint32_t lastRow_ = 0;
  std::uint32_t firstPiece_ = 0;
  std::uint32_t lastPiece_ = 0;
  bool hasPolygons_ = false;
  DistributedCut out_;
};

}  // namespace

DistributedCut ownLeaves(const CutLeaves& part, std::uint32_t first,
                         std::span<const double> volumes, std::span<const std::uint64_t> numbers) {
  return OwnLeaves(part, first, static_cast<std::uint32_t>(volumes.size()), numbers).run(volumes);
}

}  // namespace cutwater::detail
