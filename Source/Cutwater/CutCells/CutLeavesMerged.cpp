#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/CutCells/Detail/Leaves/WholeLeaves.hpp>
#include <Cutwater/CutCells/Detail/Rows/MergedRows.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// The leaves of an octree as places: their lowest cells on the finest level, in the order of cells
/// there. So an octree of one level has the order of its grid.
class MergeOctree final : public MergeGraph::Mesh {
 public:
  using Place = MergeGraph::Place;
  using Arc = MergeGraph::Arc;

  MergeOctree(const LeafGrid& grid, std::span<const FluidClass> classes)
      : grid_(grid), classes_(classes) {}

  /// In place of a leaf: there is none.
  static constexpr Place kNowhere = ~Place{0};

  [[nodiscard]] Place placeOf(std::uint32_t leaf) const {
    if (leaf == LeafGrid::kNoLeaf) return kNowhere;
    const auto [i, j, k] = onFinest(leaf);
    const auto n = [](std::int32_t at) { return static_cast<Place>(at); };
    return (n(k) << kBits | n(j)) << kBits | n(i);
  }
  [[nodiscard]] std::uint32_t leafAt(Place place) const {
    return grid_.at(cellAt(place), grid_.deepest());
  }
  /// In the order of leaves.
  [[nodiscard]] static detail::MortonCode codeOf(Place place) {
    return detail::mortonCode(cellAt(place));
  }
  /// Of the face of an arc: that cell of the finest level above its lowest corner, in the order of
  /// cells; then the axis.
  using Corner = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::uint8_t>;
  [[nodiscard]] Corner cornerOf(const Arc& arc) const {
    auto at = cellAt(arc.owner);
    if (arc.isHigh) along(at, arc.axis) += std::int32_t{1} << shift(leafAt(arc.owner));
    return {at.k, at.j, at.i, arc.axis};
  }

  [[nodiscard]] Box<double> boxOf(Place place) const override { return grid_.boxOf(leafAt(place)); }
  [[nodiscard]] std::vector<Arc> facesOfWhole(Place place) const override {
    std::vector<Arc> faces;
    const auto leaf = leafAt(place);
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      for (const bool isHigh : {false, true}) {
        const auto [what, other] = grid_.across(leaf, axis, isHigh);
        if (what == LeafGrid::Across::Finer) {
          for (const auto finer : grid_.finerAcross(leaf, axis, isHigh)) {
            if (isWhole(finer)) faces.push_back(faceOf(finer, axis, !isHigh, leaf));
          }
        } else if (what == LeafGrid::Across::Nothing || isWhole(other)) {
          faces.push_back(faceOf(leaf, axis, isHigh, other));
        }
      }
    }
    return faces;
  }
  /// An arc in a face of a leaf. Of two leaves of a level, the one above counts as the finer one.
  [[nodiscard]] Arc arcIn(std::uint32_t below, std::uint32_t above, std::uint8_t axis) const {
    const bool isHigh =
        above == LeafGrid::kNoLeaf || (below != LeafGrid::kNoLeaf && level(below) > level(above));
    return {.owner = placeOf(isHigh ? below : above),
            .other = placeOf(isHigh ? above : below),
            .centroid = {},
            .axis = axis,
            .isHigh = isHigh};
  }

 private:
  static constexpr int kBits = detail::kMortonBits;

  [[nodiscard]] static Index3 cellAt(Place place) {
    const auto at = [&](int axis) {
      return static_cast<std::int32_t>(place >> axis * kBits & ((Place{1} << kBits) - 1));
    };
    return {at(0), at(1), at(2)};
  }
  [[nodiscard]] int level(std::uint32_t leaf) const { return grid_.leaves()[leaf].level; }
  [[nodiscard]] int shift(std::uint32_t leaf) const { return grid_.deepest() - level(leaf); }
  [[nodiscard]] Index3 onFinest(std::uint32_t leaf) const {
    const auto& [i, j, k] = grid_.leaves()[leaf].index;
    return {i << shift(leaf), j << shift(leaf), k << shift(leaf)};
  }
  [[nodiscard]] bool isWhole(std::uint32_t leaf) const {
    return classes_[leaf] == FluidClass::Fluid;
  }
  /// All of a leaf's face, to another leaf.
  [[nodiscard]] Arc faceOf(std::uint32_t leaf, std::uint8_t axis, bool isHigh,
                           std::uint32_t other) const {
    auto arc = arcIn(isHigh ? leaf : other, isHigh ? other : leaf, axis);
    if (other == LeafGrid::kNoLeaf) (isHigh ? arc.above : arc.below) = CutCells::kBeyond;
    const auto box = grid_.boxOf(leaf);
    arc.area = grid_.faceArea(leaf, axis);
    arc.centroid = box.center();
    arc.centroid[axis] = isHigh ? box.upper[axis] : box.lower[axis];
    return arc;
  }

  const LeafGrid& grid_;
  std::span<const FluidClass> classes_;
};

class LeafMerging {
 public:
  LeafMerging(const CutLeaves& leaves, const LeafGrid& grid)
      : in_(leaves),
        grid_(grid),
        mesh_(grid, leaves.classes),
        graph_(mesh_, leaves.pieces.cell.size(), leaves.arcs.area.size()) {
    addPieces();
    addArcs();
  }

  MergedLeaves run(double smallest) {
    graph_.cover(smallest);
    const auto kept = graph_.kept(&MergeOctree::codeOf);
    auto& out = out_.leaves;
    for (const auto node : kept) {
      out.cut.leaf.push_back(mesh_.leafAt(graph_.nodes()[node].place));
      out.cut.box.push_back(grid_.boxOf(out.cut.leaf.back()));
    }
    MergedRows rows(in_, graph_, kept, out);
    rows.addPieces();
    const auto nameOf = [](const MergeGraph::Arc& arc) {
      return std::tuple(MergeOctree::codeOf(arc.owner), arc.axis, arc.isHigh);
    };
    rows.forOpenArcs(nameOf, [&](const MergeGraph::Arc& arc) {
      rows.addArc(arc);
      const bool isNew = arc.source == CutCells::kNoRow;
      out.arcs.leafBelow.push_back(isNew ? leafOrNone(arc.placeBelow())
                                         : in_.arcs.leafBelow[arc.source]);
      out.arcs.leafAbove.push_back(isNew ? leafOrNone(arc.placeAbove())
                                         : in_.arcs.leafAbove[arc.source]);
      out.arcs.faceArea.push_back(isNew ? grid_.faceArea(mesh_.leafAt(arc.owner), arc.axis)
                                        : in_.arcs.faceArea[arc.source]);
    });
    addLost();
    addClasses();
    return std::move(out_);
  }

 private:
  void addPieces() {
    std::vector<std::pair<MergeGraph::Place, std::uint32_t>> rows;
    for (std::uint32_t row = 0; row < in_.cut.leaf.size(); ++row) {
      rows.emplace_back(mesh_.placeOf(in_.cut.leaf[row]), row);
    }
    std::ranges::sort(rows);
    nodeOf_.resize(in_.pieces.cell.size());
    for (const auto& [place, row] : rows) {
      for (auto p = in_.cut.firstPiece[row]; p < in_.cut.firstPiece[row + 1]; ++p) {
        nodeOf_[p] = static_cast<std::uint32_t>(graph_.nodes().size());
        graph_.add(MergeGraph::Node{.place = place,
                                    .source = p,
                                    .volume = in_.pieces.volume[p],
                                    .centroid = in_.pieces.centroid[p],
                                    .wallArea = in_.pieces.wallArea[p],
                                    .wallVector = in_.pieces.wallVector[p],
                                    .closed = Moments(in_.pieces.centroid[p])});
      }
    }
  }
  /// In the order of the cells above the faces, and of axes.
  void addArcs() {
    const auto& in = in_.arcs;
    std::vector<std::pair<MergeOctree::Corner, std::uint32_t>> order;
    for (std::uint32_t a = 0; a < in.area.size(); ++a) {
      order.emplace_back(mesh_.cornerOf(arcOf(a)), a);
    }
    std::ranges::sort(order);
    for (const auto& [corner, a] : order) graph_.add(arcOf(a));
  }
  [[nodiscard]] MergeGraph::Arc arcOf(std::uint32_t a) const {
    const auto nodeOf = [&](std::uint32_t side) {
      return side < nodeOf_.size() ? nodeOf_[side] : side;
    };
    const auto& in = in_.arcs;
    auto arc = mesh_.arcIn(in.leafBelow[a], in.leafAbove[a], in.axis[a]);
    arc.below = nodeOf(in.below[a]);
    arc.above = nodeOf(in.above[a]);
    arc.area = in.area[a];
    arc.centroid = in.centroid[a];
    arc.source = a;
    return arc;
  }
  [[nodiscard]] std::uint32_t leafOrNone(MergeGraph::Place place) const {
    return place == MergeOctree::kNowhere ? CutLeaves::kNoLeaf : mesh_.leafAt(place);
  }
  void addLost() {
    for (const auto& node : graph_.nodes()) {
      if (node.isCovered) out_.lost.push_back({mesh_.leafAt(node.place), node.volume});
    }
    std::ranges::stable_sort(out_.lost, {}, &LostLeafPiece::leaf);
  }
  /// Leaves that were cut and are no more are body.
  void addClasses() {
    auto& out = out_.leaves;
    out.classes = in_.classes;
    for (const auto leaf : in_.cut.leaf) out.classes[leaf] = FluidClass::Body;
    for (const auto& [leaf, volume] : out_.lost) out.classes[leaf] = FluidClass::Body;
    for (const auto leaf : out.cut.leaf) out.classes[leaf] = FluidClass::Cut;
    sumWholeLeaves(grid_, out);
  }

  const CutLeaves& in_;
  const LeafGrid& grid_;
  MergeOctree mesh_;
  MergeGraph graph_;
  std::vector<std::uint32_t> nodeOf_;  // of pieces
  MergedLeaves out_;
};

}  // namespace

template <std::floating_point T>
MergedLeaves merged(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                    const MergeOptions& options) {
  require(options.smallest >= 0 && options.smallest <= 1,
          "merged: need a smallest fraction from 0 to 1", Named{"smallest", options.smallest});
  require(leaves.classes.size() == mesh.cells().size(), "merged: need the mesh of these leaves",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  return LeafMerging(leaves, LeafGrid(mesh, CutFrame{})).run(options.smallest);
}

template MergedLeaves merged(const CutLeaves&, const OctreeCells<float>&, const MergeOptions&);
template MergedLeaves merged(const CutLeaves&, const OctreeCells<double>&, const MergeOptions&);

}  // namespace cutwater
