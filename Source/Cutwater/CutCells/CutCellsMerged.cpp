#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Rows/MergedRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PeriodicRows.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

/// The cells of a box as places: numbers in the order of cells, with those around the box.
class MergeBox final : public MergeGraph::Mesh {
 public:
  using Place = MergeGraph::Place;

  MergeBox(const CutCells& cells, const SpannedAxes& spanned)
      : cells_(cells), box_(cells.grid.indices()), spanned_(spanned) {}

  [[nodiscard]] Place placeOf(const Index3& cell) const {
    const auto from = [](std::int32_t lower, std::int32_t at) {
      return static_cast<Place>(std::int64_t{at} - lower + 1);
    };
    return (from(box_.lo.k, cell.k) * along(1) + from(box_.lo.j, cell.j)) * along(0) +
           from(box_.lo.i, cell.i);
  }
  [[nodiscard]] Index3 cellAt(Place place) const {
    const auto to = [](std::int32_t lower, Place n) {
      return static_cast<std::int32_t>(lower + static_cast<std::int64_t>(n) - 1);
    };
    return {to(box_.lo.i, place % along(0)), to(box_.lo.j, place / along(0) % along(1)),
            to(box_.lo.k, place / along(0) / along(1))};
  }
  [[nodiscard]] Box<double> boxOf(Place place) const override {
    return cells_.boxOf(cellAt(place));
  }
  [[nodiscard]] std::vector<MergeGraph::Arc> facesOfWhole(Place place) const override {
    std::vector<MergeGraph::Arc> faces;
    const auto cell = cellAt(place);
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      for (const bool isHigh : {false, true}) {
        const auto other = inPeriod(cells_.grid, spanned_, beside(cell, axis, isHigh));
        const bool isIn = box_.contains(other);
        if (isIn && cells_.classOf(other) != FluidClass::Fluid) continue;
        auto& face = faces.emplace_back(faceBelow(isHigh ? other : cell, axis));
        if (!isIn) (isHigh ? face.above : face.below) = CutCells::kBeyond;
        face.area = cells_.faceArea(cell, axis);
        face.centroid = cells_.boxOf(cell).center();
        face.centroid[axis] = cells_.boxOf(isHigh ? other : cell).lower[axis];
      }
    }
    return faces;
  }
  /// The face below a cell.
  [[nodiscard]] MergeGraph::Arc faceBelow(const Index3& cell, std::uint8_t axis) const {
    const auto below = beside(cell, axis, false);
    const auto other = inPeriod(cells_.grid, spanned_, below);
    const double way =
        other == below ? 0 : cells_.boxOf(other).upper[axis] - cells_.boxOf(cell).lower[axis];
    return {.owner = placeOf(cell),
            .other = placeOf(other),
            .centroid = {},
            .axis = axis,
            .belowBy = way};
  }

 private:
  /// The cells of the box along an axis, and one more on each side.
  [[nodiscard]] Place along(int axis) const { return box_.length(axis) + 2; }
  [[nodiscard]] static Index3 beside(Index3 cell, int axis, bool isHigh) {
    cutwater::along(cell, axis) += isHigh ? 1 : -1;
    return cell;
  }

  const CutCells& cells_;
  IndexBox box_;
  SpannedAxes spanned_;
};

class CellMerging {
 public:
  CellMerging(const CutCells& cells, const SpannedAxes& spanned)
      : in_(cells),
        box_(cells.grid.indices()),
        spanned_(spanned),
        mesh_(cells, spanned),
        graph_(mesh_, cells.pieceCount, cells.arcs.area.size()) {
    for (std::uint32_t piece = 0; piece < in_.pieceCount; ++piece) {
      graph_.add(MergeGraph::Node{.place = mesh_.placeOf(in_.cells.index[in_.pieces.cell[piece]]),
                                  .source = piece,
                                  .volume = in_.pieces.volume[piece],
                                  .centroid = in_.pieces.centroid[piece],
                                  .wallArea = in_.pieces.wallArea[piece],
                                  .wallVector = in_.pieces.wallVector[piece],
                                  .closed = Moments(in_.pieces.centroid[piece])});
    }
    for (std::uint32_t a = 0; a < in_.arcs.area.size(); ++a) {
      auto arc = mesh_.faceBelow(in_.arcs.cell[a], in_.arcs.axis[a]);
      arc.below = knownSide(in_.arcs.below[a], in_.arcs.cellBelow(a));
      arc.above = knownSide(in_.arcs.above[a], in_.arcs.cell[a]);
      arc.area = in_.arcs.area[a];
      arc.centroid = in_.arcs.centroid[a];
      arc.source = a;
      graph_.add(arc);
    }
  }

  MergedCells run(double smallest) {
    graph_.cover(smallest);
    const auto kept = graph_.kept([](MergeGraph::Place place) { return place; });
    auto& out = out_.cells;
    out.grid = in_.grid;
    out.cellCount = kept.size();
    out.pieceCount = kept.size();
    for (const auto node : kept) {
      out.cells.index.push_back(mesh_.cellAt(graph_.nodes()[node].place));
    }
    MergedRows rows(in_, graph_, kept, out);
    rows.addPieces();
    const auto nameOf = [](const MergeGraph::Arc& arc) { return std::pair(arc.owner, arc.axis); };
    rows.forOpenArcs(nameOf, [&](const MergeGraph::Arc& arc) {
      rows.addArc(arc);
      out.arcs.cell.push_back(mesh_.cellAt(arc.owner));
    });
    addLost();
    addBodyRuns();
    return std::move(out_);
  }

 private:
  /// Pieces beyond the box are not known.
  [[nodiscard]] std::uint32_t knownSide(std::uint32_t side, const Index3& cell) const {
    if (side < in_.pieceCount) return side;
    const bool isIn = box_.contains(inPeriod(in_.grid, spanned_, cell));
    return side == CutCells::kWholeCell && isIn ? side : CutCells::kBeyond;
  }
  void addLost() {
    for (const auto& node : graph_.nodes()) {
      if (node.isCovered) out_.lost.push_back({mesh_.cellAt(node.place), node.volume});
    }
    std::ranges::stable_sort(out_.lost, {},
                             [&](const LostPiece& piece) { return mesh_.placeOf(piece.cell); });
  }
  /// Cells without fluid before, and those whose pieces are all covered.
  void addBodyRuns() {
    auto runs = in_.bodyRuns;
    for (const auto& [cell, volume] : out_.lost) {
      if (out_.cells.rowOf(cell) != CutCells::kNoRow) continue;
      const auto number = numberOf(cell);
      runs.push_back({number, number + 1});
    }
    std::ranges::sort(runs);
    for (const auto& [first, last] : runs) {
      auto& joined = out_.cells.bodyRuns;
      if (!joined.empty() && first <= joined.back()[1]) {
        joined.back()[1] = std::max(joined.back()[1], last);
      } else {
        joined.push_back({first, last});
      }
    }
  }
  /// In the order of the box's cells.
  [[nodiscard]] std::uint64_t numberOf(const Index3& cell) const {
    const auto n = [](std::int32_t i) { return static_cast<std::uint64_t>(i); };
    const auto& lo = box_.lo;
    return (n(cell.k - lo.k) * box_.length(1) + n(cell.j - lo.j)) * box_.length(0) +
           n(cell.i - lo.i);
  }

  const CutCells& in_;
  IndexBox box_;
  SpannedAxes spanned_;
  MergeBox mesh_;
  MergeGraph graph_;
  MergedCells out_;
};

}  // namespace

MergedCells merged(const CutCells& cells, const MergeOptions& options) {
  require(options.smallest >= 0 && options.smallest <= 1,
          "merged: need a smallest fraction from 0 to 1", Named{"smallest", options.smallest});
  auto spanned = spannedAxes(cells.grid);
  for (std::size_t a = 0; a < 3; ++a) spanned[a] = spanned[a] && cells.grid.period[a] > 1;
  if (spanned == SpannedAxes{}) return CellMerging(cells, spanned).run(options.smallest);
  const auto joined = withJoinedEnds(cells, spanned);
  auto result = CellMerging(joined, spanned).run(options.smallest);
  separateEnds(result.cells, spanned);
  return result;
}

}  // namespace cutwater
