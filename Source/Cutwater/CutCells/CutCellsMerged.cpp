#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Moments/MomentRows.hpp>
#include <Cutwater/CutCells/Detail/Moments/Moments.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// Of a cell's largest face: a wall's vector that is less is rounding.
constexpr double kNoDirection = 1e-13;

auto inOrder(const Index3& cell) {
  return std::tuple(cell.k, cell.j, cell.i);
}

/// Covers pieces and closes what leads to them, until one piece at most is left in every cell.
class Merging {
 public:
  Merging(const CutCells& cells, const MergeOptions& options)
      : in_(cells), options_(options), box_(cells.grid.indices()) {
    for (std::uint32_t piece = 0; piece < in_.pieceCount; ++piece) {
      nodes_.push_back({.cell = in_.cells.index[in_.pieces.cell[piece]],
                        .source = piece,
                        .volume = in_.pieces.volume[piece],
                        .centroid = in_.pieces.centroid[piece],
                        .wallVector = in_.pieces.wallVector[piece],
                        .closed = Moments(in_.pieces.centroid[piece])});
    }
    addArcs();
  }

  MergedCells run() {
    for (std::uint32_t row = 0; row < in_.cellCount; ++row) {
      const auto kept = keptOf(row);
      for (auto p = in_.cells.firstPiece[row]; p < in_.cells.firstPiece[row + 1]; ++p) {
        if (p != kept || in_.volumeFraction(p) < options_.smallest) cover(p);
      }
    }
    // Covering closes faces of neighbours, which may leave these without a direction of the wall.
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) changed_.push_back(node);
    while (!changed_.empty()) {
      const auto node = changed_.back();
      changed_.pop_back();
      if (!nodes_[node].isCovered && !hasDirection(nodes_[node])) cover(node);
    }
    return result();
  }

 private:
  /// A piece, or a cell that was all fluid before one of its faces was closed.
  struct Node {
    Index3 cell;
    std::uint32_t source = CutCells::kNoRow;  ///< the piece
    double volume = 0;
    Vec3<double> centroid;
    Vec3<double> wallVector;
    Moments closed;  ///< the faces that were closed
    Vec3<double> closedVector = {};
    bool isCovered = false;
    std::vector<std::uint32_t> arcs = {};
  };
  struct Arc {
    std::uint32_t below = 0;  ///< a node, kWholeCell or kBeyond
    std::uint32_t above = 0;
    double area = 0;
    Vec3<double> centroid;
    Index3 cell;
    std::uint8_t axis = 0;
    std::uint32_t source = CutCells::kNoRow;  ///< the arc; kNoRow for a whole face
    bool isClosed = false;
  };

  /// The largest piece of a cell, the first of these.
  [[nodiscard]] std::uint32_t keptOf(std::size_t row) const {
    auto kept = in_.cells.firstPiece[row];
    for (auto p = kept; p < in_.cells.firstPiece[row + 1]; ++p) {
      if (in_.pieces.volume[p] > in_.pieces.volume[kept]) kept = p;
    }
    return kept;
  }
  /// Cells without a wall, which open patches bound, need none.
  [[nodiscard]] bool hasDirection(const Node& node) const {
    const bool isPiece = node.source != CutCells::kNoRow;
    const double wall = isPiece ? in_.pieces.wallArea[node.source] : 0;
    if (wall == 0 && node.closed.size() == 0) return true;
    const double face = std::max(
        {in_.faceArea(node.cell, 0), in_.faceArea(node.cell, 1), in_.faceArea(node.cell, 2)});
    return length(node.wallVector) > kNoDirection * face;
  }

  [[nodiscard]] static Index3 below(Index3 cell, int axis) {
    --(axis == 0 ? cell.i : axis == 1 ? cell.j : cell.k);
    return cell;
  }
  [[nodiscard]] static Index3 above(Index3 cell, int axis) {
    ++(axis == 0 ? cell.i : axis == 1 ? cell.j : cell.k);
    return cell;
  }

  void addArcs() {
    const auto& in = in_.arcs;
    for (std::uint32_t a = 0; a < in.area.size(); ++a) {
      const auto known = [&](std::uint32_t side) {
        const bool isBeyond = side >= in_.pieceCount && side < in_.pieces.cell.size();
        return isBeyond ? CutCells::kBeyond : side;
      };
      addArc({.below = known(in.below[a]),
              .above = known(in.above[a]),
              .area = in.area[a],
              .centroid = in.centroid[a],
              .cell = in.cell[a],
              .axis = in.axis[a],
              .source = a});
    }
  }
  void addArc(Arc arc) {
    const auto number = static_cast<std::uint32_t>(arcs_.size());
    const auto note = [&](std::uint32_t& side, const Index3& cell) {
      if (side < nodes_.size()) {
        nodes_[side].arcs.push_back(number);
      } else if (side == CutCells::kWholeCell) {
        if (box_.contains(cell)) {
          ofWhole_[inOrder(cell)].push_back(number);
        } else {
          side = CutCells::kBeyond;
        }
      }
    };
    note(arc.below, below(arc.cell, arc.axis));
    note(arc.above, arc.cell);
    arcs_.push_back(arc);
  }

  /// Makes a node of a cell that was all fluid.
  std::uint32_t nodeOfWhole(const Index3& cell) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    const auto center = in_.boxOf(cell).center();
    nodes_.push_back({.cell = cell,
                      .volume = in_.cellVolume(cell),
                      .centroid = center,
                      .wallVector = {},
                      .closed = Moments(center)});
    nodes_[node].arcs = std::move(ofWhole_[inOrder(cell)]);
    ofWhole_.erase(inOrder(cell));
    std::array<bool, 6> isKnown{};
    for (const auto number : nodes_[node].arcs) {
      auto& arc = arcs_[number];
      const bool isAbove = arc.cell == cell;
      (isAbove ? arc.above : arc.below) = node;
      isKnown[2 * arc.axis + (isAbove ? 0U : 1U)] = true;
    }
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      for (const bool isBelow : {true, false}) {
        const auto other = isBelow ? below(cell, axis) : above(cell, axis);
        if (isKnown[2 * axis + (isBelow ? 0U : 1U)]) continue;
        const bool isIn = box_.contains(other);
        if (isIn && in_.classOf(other) != FluidClass::Fluid) continue;
        const auto beside = isIn ? CutCells::kWholeCell : CutCells::kBeyond;
        addWholeFace(cell, axis, isBelow ? beside : node, isBelow ? node : beside);
      }
    }
    return node;
  }
  void addWholeFace(const Index3& cell, std::uint8_t axis, std::uint32_t below,
                    std::uint32_t above) {
    const auto box = in_.boxOf(cell);
    auto centroid = box.center();
    const bool isLower = above < nodes_.size();
    centroid[axis] = isLower ? box.lower[axis] : box.upper[axis];
    addArc({.below = below,
            .above = above,
            .area = in_.faceArea(cell, axis),
            .centroid = centroid,
            .cell = isLower ? cell : Merging::above(cell, axis),
            .axis = axis});
  }

  void cover(std::uint32_t node) {
    nodes_[node].isCovered = true;
    lost_.push_back({nodes_[node].cell, nodes_[node].volume});
    const auto arcs = nodes_[node].arcs;
    for (const auto arc : arcs) close(arc);
  }
  /// Makes the arc a wall of what is not covered beside it.
  void close(std::uint32_t number) {
    if (std::exchange(arcs_[number].isClosed, true)) return;
    for (const bool isBelow : {true, false}) {
      const auto arc = arcs_[number];
      auto side = isBelow ? arc.below : arc.above;
      if (side == CutCells::kWholeCell) {
        side = nodeOfWhole(isBelow ? below(arc.cell, arc.axis) : arc.cell);
      }
      if (side >= nodes_.size() || nodes_[side].isCovered) continue;
      auto& node = nodes_[side];
      Vec3<double> vector;
      vector[arc.axis] = isBelow ? arc.area : -arc.area;
      node.closed.add(arc.area, arc.centroid);
      node.closedVector += vector;
      node.wallVector += vector;
      changed_.push_back(side);
    }
  }
  MergedCells result() {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      if (!nodes_[node].isCovered) kept.push_back(node);
    }
    std::ranges::sort(kept, {}, [&](std::uint32_t node) { return inOrder(nodes_[node].cell); });
    out_.cells.grid = in_.grid;
    out_.cells.patchNames = in_.patchNames;
    out_.cells.patchNames.emplace_back("covered");
    std::vector<std::uint32_t> pieceOf(nodes_.size(), CutCells::kNoRow);
    for (const auto node : kept) {
      pieceOf[node] = static_cast<std::uint32_t>(out_.cells.pieceCount);
      addPiece(nodes_[node]);
    }
    out_.cells.cellCount = out_.cells.pieceCount;
    out_.cells.cells.firstPiece.push_back(static_cast<std::uint32_t>(out_.cells.pieceCount));
    if (in_.moments.degree >= 0) addMoments(kept);
    addOpenArcs(pieceOf);
    addBodyRuns();
    std::ranges::sort(lost_, {}, [](const LostPiece& piece) { return inOrder(piece.cell); });
    out_.lost = std::move(lost_);
    return std::move(out_);
  }
  void addPiece(const Node& node) {
    auto& cells = out_.cells;
    const auto number = static_cast<std::uint32_t>(cells.pieceCount++);
    const bool isPiece = node.source != CutCells::kNoRow;
    cells.cells.index.push_back(node.cell);
    cells.cells.firstPiece.push_back(number);
    cells.cells.fluidCorners.push_back(
        isPiece ? in_.cells.fluidCorners[in_.pieces.cell[node.source]] : std::uint8_t{0xff});
    cells.cells.meets.push_back(isPiece ? in_.cells.meets[in_.pieces.cell[node.source]]
                                        : std::uint8_t{0});
    auto wall = Moments(node.centroid);
    if (isPiece) {
      wall.add(in_.pieces.wallArea[node.source], in_.pieces.wallCentroid[node.source]);
      addWallParts(node.source, number);
    }
    if (node.closed.size() > 0) {
      wall.add(node.closed.size(), node.closed.centroid());
      addWallPart(number, cells.patchNames.size() - 1, node.closed.size(), node.closedVector,
                  node.closed.centroid());
    }
    cells.pieces.cell.push_back(number);
    cells.pieces.volume.push_back(node.volume);
    cells.pieces.centroid.push_back(node.centroid);
    cells.pieces.wallArea.push_back(wall.size());
    cells.pieces.wallVector.push_back(node.wallVector);
    cells.pieces.wallCentroid.push_back(wall.size() > 0 ? wall.centroid() : node.centroid);
  }
  void addWallParts(std::uint32_t source, std::uint32_t piece) {
    const auto& in = in_.wallParts;
    const auto first = std::ranges::lower_bound(in.piece, source) - in.piece.begin();
    for (auto n = static_cast<std::size_t>(first); n < in.piece.size() && in.piece[n] == source;
         ++n) {
      addWallPart(piece, in.patch[n], in.area[n], in.vector[n], in.centroid[n]);
    }
  }
  void addWallPart(std::uint32_t piece, std::size_t patch, double area, const Vec3<double>& vector,
                   const Vec3<double>& centroid) {
    auto& parts = out_.cells.wallParts;
    parts.piece.push_back(piece);
    parts.patch.push_back(static_cast<std::uint32_t>(patch));
    parts.area.push_back(area);
    parts.vector.push_back(vector);
    parts.centroid.push_back(centroid);
  }
  /// Of the nodes that are pieces now, in their order.
  void addMoments(std::span<const std::uint32_t> kept) {
    MomentRows rows(out_.cells, in_.moments.degree);
    for (std::size_t piece = 0; piece < kept.size(); ++piece) {
      const auto& node = nodes_[kept[piece]];
      if (node.source != CutCells::kNoRow) {
        rows.addPiece(piece, in_, node.source);
      } else {
        rows.addBox(piece, in_.boxOf(node.cell));
      }
      const auto& about = out_.cells.pieces.wallCentroid[piece];
      for (const auto number : node.arcs) {
        const auto& arc = arcs_[number];
        if (!arc.isClosed) continue;
        const auto ofFace = momentsOfFace(in_, arc.source, arc.cell, arc.axis, about);
        const double distance = in_.boxOf(arc.cell).lower[arc.axis] - about[arc.axis];
        rows.addClosedFace(piece, ofFace, arc.axis, distance, arc.below == kept[piece] ? 1 : -1);
      }
    }
  }
  void addOpenArcs(std::span<const std::uint32_t> pieceOf) {
    std::erase_if(arcs_, [](const Arc& arc) { return arc.isClosed; });
    std::ranges::stable_sort(arcs_, {}, [](const Arc& arc) {
      return std::tuple(arc.cell.k, arc.cell.j, arc.cell.i, arc.axis);
    });
    const auto sideOf = [&](std::uint32_t side) {
      return side < pieceOf.size() ? pieceOf[side] : side;
    };
    auto& arcs = out_.cells.arcs;
    for (const auto& arc : arcs_) {
      const auto patch = in_.openArcs.patchOf(arc.source);
      if (patch != CutCells::kNoRow) addOpenRow(arcs.area.size(), patch, out_.cells.openArcs);
      arcs.below.push_back(sideOf(arc.below));
      arcs.above.push_back(sideOf(arc.above));
      arcs.area.push_back(arc.area);
      arcs.centroid.push_back(arc.centroid);
      arcs.cell.push_back(arc.cell);
      arcs.axis.push_back(arc.axis);
      if (in_.moments.degree < 0) continue;
      const auto moments = momentsOfFace(in_, arc.source, arc.cell, arc.axis, arc.centroid);
      auto& rows = out_.cells.moments.arc;
      rows.insert(rows.end(), moments.begin(),
                  moments.begin() + static_cast<std::ptrdiff_t>(in_.moments.perArc()));
    }
  }
  /// Cells without fluid before, and those whose pieces are all covered.
  void addBodyRuns() {
    const auto& rows = out_.cells.cells.index;
    auto runs = in_.bodyRuns;
    for (const auto& [cell, volume] : lost_) {
      if (std::ranges::binary_search(rows, inOrder(cell), {}, inOrder)) continue;
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
  MergeOptions options_;
  IndexBox box_;
  std::vector<Node> nodes_;  // pieces of the box, by their numbers; then cells that were all fluid
  std::vector<Arc> arcs_;    // those of the cells, then faces of cells that were all fluid
  /// Arcs to cells that are all fluid, by cell.
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, std::vector<std::uint32_t>>
      ofWhole_;
  std::vector<std::uint32_t> changed_;  // nodes whose walls have grown
  std::vector<LostPiece> lost_;
  MergedCells out_;
};

}  // namespace

MergedCells merged(const CutCells& cells, const MergeOptions& options) {
  require(options.smallest >= 0 && options.smallest <= 1,
          "merged: need a smallest fraction from 0 to 1", Named{"smallest", options.smallest});
  return Merging(cells, options).run();
}

}  // namespace cutwater
