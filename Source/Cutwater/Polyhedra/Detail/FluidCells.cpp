#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Polyhedra/Detail/FluidCells.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace cutwater {

/// Joins small pieces to what is across their largest face. Nodes are pieces, then leaves.
class FluidCells::Joining {
 public:
  explicit Joining(const CutLeaves& leaves)
      : leaves_(leaves),
        pieces_(static_cast<std::uint32_t>(leaves.pieces.volume.size())),
        sets_(leaves.pieces.volume.size() + leaves.classes.size()),
        members_(pieces_),
        volume_(leaves.pieces.volume) {
    const auto& arcs = leaves.arcs;
    for (std::uint32_t arc = 0; arc < arcs.area.size(); ++arc) {
      const auto below = nodeOf(arcs.below[arc], arcs.leafBelow[arc]);
      const auto above = nodeOf(arcs.above[arc], arcs.leafAbove[arc]);
      if (below == kNone || above == kNone) continue;
      if (below < pieces_) faces_.push_back({below, above, arcs.area[arc]});
      if (above < pieces_) faces_.push_back({above, below, arcs.area[arc]});
    }
    std::ranges::stable_sort(faces_, {}, &Face::piece);
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) members_[piece] = {piece};
  }

  void joinSmall(double smallest) {
    std::vector<std::uint32_t> order(pieces_);
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::vector<double> fraction(pieces_);
    for (std::uint32_t p = 0; p < pieces_; ++p) fraction[p] = leaves_.volumeFraction(p);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t p) { return fraction[p]; });
    for (const auto piece : order) {
      if (!(fraction[piece] < smallest)) break;
      const double least = smallest * leaves_.leafVolume(leaves_.pieces.cell[piece]);
      while (volume_[sets_.find(piece)] < least) {
        const auto other = acrossLargest(sets_.find(piece));
        if (other == kNone) break;
        unite(sets_.find(piece), other);
      }
    }
  }

  /// The node that stands for those a node was joined with.
  [[nodiscard]] std::uint32_t setOf(std::uint32_t node) { return sets_.find(node); }

 private:
  struct Face {
    std::uint32_t piece = 0;
    std::uint32_t other = 0;  // node
    double area = 0;
  };

  [[nodiscard]] std::uint32_t nodeOf(std::uint32_t piece, std::uint32_t leaf) const {
    if (piece == CutLeaves::kBeyond) return kNone;
    return piece == CutLeaves::kWholeCell ? pieces_ + leaf : piece;
  }
  /// What a set has the largest open face with, of all open parts together.
  [[nodiscard]] std::uint32_t acrossLargest(std::uint32_t set) {
    std::vector<std::pair<std::uint32_t, double>> areas;
    for (const auto piece : members_[set]) {
      auto face = std::ranges::lower_bound(faces_, piece, {}, &Face::piece);
      for (; face != faces_.end() && face->piece == piece; ++face) {
        const auto other = sets_.find(face->other);
        if (other != set) areas.emplace_back(other, face->area);
      }
    }
    std::ranges::sort(areas);
    std::uint32_t best = kNone;
    double largest = 0;
    double sum = 0;
    for (std::size_t n = 0; n < areas.size(); ++n) {
      sum = n > 0 && areas[n].first == areas[n - 1].first ? sum + areas[n].second : areas[n].second;
      if (sum > largest) {
        largest = sum;
        best = areas[n].first;
      }
    }
    return best;
  }
  /// One of them is a piece, and so is the node that stands for both.
  void unite(std::uint32_t a, std::uint32_t b) {
    sets_.unite(a, b);
    const auto to = std::min(a, b);
    const auto from = std::max(a, b);
    if (from >= pieces_) {
      volume_[to] = std::numeric_limits<double>::infinity();  // no longer small
      return;
    }
    volume_[to] += volume_[from];
    members_[to].insert(members_[to].end(), members_[from].begin(), members_[from].end());
    members_[from] = {};
  }

  const CutLeaves& leaves_;
  std::uint32_t pieces_;
  detail::DisjointSets sets_;
  std::vector<Face> faces_;                          // of pieces, sorted by these
  std::vector<std::vector<std::uint32_t>> members_;  // of each set of pieces
  std::vector<double> volume_;
};

FluidCells::FluidCells(const CutLeaves& leaves, const LeafGrid& grid, const KeptRegions& regions,
                       double smallest)
    : pieces_(static_cast<std::uint32_t>(leaves.pieces.volume.size())),
      cells_(pieces_ + leaves.classes.size(), kNone) {
  Joining joining(leaves);
  joining.joinSmall(smallest);
  std::vector<std::uint32_t> cellOfSet(cells_.size(), kNone);
  const auto add = [&](std::uint32_t node, std::uint32_t leaf, std::uint32_t region,
                       double volume) {
    if (region == kNone) return;
    auto& cell = cellOfSet[joining.setOf(node)];
    if (cell == kNone) {
      cell = static_cast<std::uint32_t>(rows_.leaf.size());
      rows_.leaf.push_back(leaf);
      rows_.volume.push_back(0);
      rows_.region.push_back(region);
    } else {
      ++joinedPieces_;
    }
    rows_.volume[cell] += volume;
    cells_[node] = cell;
  };
  std::uint32_t piece = 0;
  for (std::uint32_t leaf = 0; leaf < leaves.classes.size(); ++leaf) {
    if (leaves.classes[leaf] == FluidClass::Fluid) {
      add(pieces_ + leaf, leaf, regions.ofLeaf(leaf), grid.volume(leaf));
    }
    for (; piece < pieces_ && leaves.cut.leaf[leaves.pieces.cell[piece]] == leaf; ++piece) {
      add(piece, leaf, regions.ofPiece(piece), leaves.pieces.volume[piece]);
    }
  }
}

}  // namespace cutwater
