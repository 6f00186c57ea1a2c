#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/CutCells/Detail/Rows/PeriodicRows.hpp>

#include <algorithm>
#include <numeric>

// CutRegions.

namespace cutwater {

namespace {

/// Counted through the box, i fastest.
std::uint64_t numberIn(const IndexBox& box, const Index3& cell) {
  const auto from = [](std::int32_t lower, std::int32_t at) {
    return static_cast<std::uint64_t>(std::int64_t{at} - lower);
  };
  return (from(box.lo.k, cell.k) * box.length(1) + from(box.lo.j, cell.j)) * box.length(0) +
         from(box.lo.i, cell.i);
}

}  // namespace

/// Joins nodes: the pieces, and behind them runs of whole cells or leaves.
class CutRegions::Builder {
 public:
  explicit Builder(CutRegions& owner) : owner_(owner) {}

  void build(const CutCells& cells) {
    const auto& box = owner_.box_ = cells.grid.indices();
    const auto pieces = static_cast<std::uint32_t>(cells.pieceCount);
    findRuns(cells);
    reset(pieces, owner_.runs_.size());
    joinRuns();
    const auto spanned = spannedAxes(cells.grid);
    joinAcrossPeriods(spanned);
    const auto nodeOf = [&](std::uint32_t side, const Index3& cell) {
      const auto own = inPeriod(cells.grid, spanned, cell);
      const auto node = sideInPeriod(cells, spanned, cell, side);
      if (node < pieces) return node;
      return node == CutCells::kWholeCell && box.contains(own) ? pieces + runOf(own) : kNone;
    };
    const auto& arcs = cells.arcs;
    for (std::size_t a = 0; a < arcs.area.size(); ++a) {
      join(nodeOf(arcs.below[a], arcs.cellBelow(a)), nodeOf(arcs.above[a], arcs.cell[a]));
    }
    number([&](std::uint32_t run) { return contentOf(cells, owner_.runs_[run]); },
           cells.pieces.volume);
    owner_.ofPiece_.resize(cells.pieces.volume.size(), kNone);
    for (std::uint32_t run = 0; run < owner_.runs_.size(); ++run) {
      owner_.runs_[run].region = regionOf_[pieces + run];
    }
  }

  void build(const CutLeaves& leaves, const LeafGrid& grid) {
    const auto pieces = static_cast<std::uint32_t>(leaves.pieces.volume.size());
    const auto isWhole = [&](std::uint32_t leaf) {
      return leaves.classes[leaf] == FluidClass::Fluid;
    };
    reset(pieces, leaves.classes.size());
    for (std::uint32_t leaf = 0; leaf < leaves.classes.size(); ++leaf) {
      if (!isWhole(leaf)) continue;
      for (int face = 0; face < 6; ++face) {
        const auto [what, other] = grid.across(leaf, face / 2, face % 2 == 1);
        if (what == LeafGrid::Across::Finer) continue;  // these see this one
        if (what == LeafGrid::Across::Nothing) goesOn_[pieces + leaf] = 1;
        if (what != LeafGrid::Across::Nothing && isWhole(other))
          join(pieces + leaf, pieces + other);
      }
    }
    const auto nodeOf = [&](std::uint32_t side, std::uint32_t leaf) {
      return side < pieces ? side : side == CutLeaves::kWholeCell ? pieces + leaf : kNone;
    };
    const auto& arcs = leaves.arcs;
    for (std::size_t a = 0; a < arcs.area.size(); ++a) {
      join(nodeOf(arcs.below[a], arcs.leafBelow[a]), nodeOf(arcs.above[a], arcs.leafAbove[a]));
    }
    number(
        [&](std::uint32_t leaf) {
          return isWhole(leaf) ? CutRegion{.volume = grid.volume(leaf), .wholeCells = 1}
                               : CutRegion{};
        },
        leaves.pieces.volume);
    owner_.ofLeaf_.assign(regionOf_.begin() + pieces, regionOf_.end());
  }

 private:
  void reset(std::size_t pieces, std::size_t others) {
    require(pieces + others < kNone, "CutRegions: need fewer than 2^32 - 1 pieces and cells",
            Named{"pieces", pieces}, Named{"cells", others});
    pieces_ = pieces;
    sets_.reset(pieces + others);
    goesOn_.assign(pieces + others, 0);
  }

  /// What is neither cut nor body, in each line along x.
  void findRuns(const CutCells& cells) {
    const auto& box = owner_.box_;
    const auto line = lines()[0];
    const auto add = [&](std::uint64_t from, std::uint64_t to) {
      while (from < to) {
        const auto end = std::min(to, (from / line + 1) * line);
        owner_.runs_.push_back({.first = from, .last = end});
        from = end;
      }
    };
    std::uint64_t at = 0;
    auto body = cells.bodyRuns.begin();
    const auto skipBodyUpTo = [&](std::uint64_t end) {
      for (; body != cells.bodyRuns.end() && (*body)[0] < end; ++body) {
        add(at, std::min((*body)[0], end));
        at = std::max(at, (*body)[1]);
      }
    };
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      const auto cut = numberIn(box, cells.cells.index[row]);
      skipBodyUpTo(cut);
      add(at, cut);
      at = std::max(at, cut + 1);
    }
    skipBodyUpTo(box.count());
    add(at, box.count());
  }

  /// Neighbouring lines along x.
  void joinRuns() {
    const auto& runs = owner_.runs_;
    const auto [nx, ny] = lines();
    // For each run, those before it by a line or a layer are found by going through both lists.
    for (const auto distance : {nx, nx * ny}) {
      std::size_t before = 0;
      for (std::uint32_t n = 0; n < runs.size(); ++n) {
        const auto j = runs[n].first / nx % ny;
        if (runs[n].first < distance || (distance == nx && j == 0)) continue;
        const auto first = runs[n].first - distance;
        const auto last = runs[n].last - distance;
        while (runs[before].last <= first) ++before;
        for (auto m = before; runs[m].first < last; ++m) joinRun(n, m);
      }
    }
  }
  /// What lies at the rim of the box, with what lies beyond: the opposite rim, if the box spans a
  /// period.
  void joinAcrossPeriods(const SpannedAxes& spanned) {
    const auto& runs = owner_.runs_;
    const auto [nx, ny] = lines();
    const std::uint64_t nz = owner_.box_.length(2);
    const std::array steps{std::uint64_t{1}, nx, nx * ny};
    const std::array lengths{nx, ny, nz};
    for (std::uint32_t n = 0; n < runs.size(); ++n) {
      const auto& [first, last, region] = runs[n];
      for (std::size_t a = 0; a < 3; ++a) {
        const bool isLow = first / steps[a] % lengths[a] == 0;
        const bool isHigh = (last - 1) / steps[a] % lengths[a] + 1 == lengths[a];
        const auto across = steps[a] * (lengths[a] - 1);
        if (!spanned[a]) {
          if (isLow || isHigh) goesOn_[pieces_ + n] = 1;
        } else if (isLow) {
          joinWithin(n, first + across, (a == 0 ? first + 1 : last) + across);
        }
      }
    }
  }
  /// A run with those that have any of these cells.
  void joinWithin(std::uint32_t n, std::uint64_t first, std::uint64_t last) {
    const auto& runs = owner_.runs_;
    auto run = std::ranges::upper_bound(runs, first, {}, &Run::last);
    for (; run != runs.end() && run->first < last; ++run) {
      joinRun(n, static_cast<std::size_t>(run - runs.begin()));
    }
  }
  /// The cells of a line along x, and the lines of a layer; of an empty box, in which no run is, 1.
  [[nodiscard]] std::array<std::uint64_t, 2> lines() const {
    const auto& box = owner_.box_;
    return {std::max<std::uint64_t>(box.length(0), 1), std::max<std::uint64_t>(box.length(1), 1)};
  }
  void joinRun(std::size_t a, std::size_t b) {
    sets_.unite(static_cast<std::uint32_t>(pieces_ + a), static_cast<std::uint32_t>(pieces_ + b));
  }
  [[nodiscard]] std::uint32_t runOf(const Index3& cell) const {
    const auto after =
        std::ranges::upper_bound(owner_.runs_, numberIn(owner_.box_, cell), {}, &Run::first);
    return static_cast<std::uint32_t>(after - owner_.runs_.begin() - 1);
  }
  [[nodiscard]] CutRegion contentOf(const CutCells& cells, const Run& run) const {
    const auto [nx, ny] = lines();
    const auto& planes = cells.grid.planes;
    const auto width = [&](std::size_t axis, std::uint64_t from, std::uint64_t to) {
      return planes[axis][to + 1] - planes[axis][from + 1];  // the first plane is below the box
    };
    const auto i = run.first % nx;
    const auto j = run.first / nx % ny;
    const auto k = run.first / nx / ny;
    const auto count = run.last - run.first;
    return {.volume = width(0, i, i + count) * width(1, j, j + 1) * width(2, k, k + 1),
            .wholeCells = count};
  }

  /// Nodes on both sides of an open part; kNone: what lies beyond.
  void join(std::uint32_t a, std::uint32_t b) {
    if (a != kNone && b != kNone) {
      sets_.unite(a, b);
    } else if (a != kNone || b != kNone) {
      goesOn_[a == kNone ? b : a] = 1;
    }
  }

  /// Gives each set a number, by volume.
  template <typename ContentOf>
  void number(const ContentOf& contentOf, const std::vector<double>& volumes) {
    std::vector<CutRegion> found(goesOn_.size());  // by the least node of a set
    for (std::uint32_t n = 0; n < found.size(); ++n) {
      auto& region = found[sets_.find(n)];
      const auto own = n < pieces_ ? CutRegion{.volume = volumes[n], .pieces = 1}
                                   : contentOf(static_cast<std::uint32_t>(n - pieces_));
      region.volume += own.volume;
      region.pieces += own.pieces;
      region.wholeCells += own.wholeCells;
      region.goesOn = region.goesOn || goesOn_[n] != 0;
    }
    std::vector<std::uint32_t> roots;
    for (std::uint32_t n = 0; n < found.size(); ++n) {
      if (found[n].pieces + found[n].wholeCells > 0) roots.push_back(n);
    }
    std::ranges::stable_sort(roots, std::greater{}, [&](auto n) { return found[n].volume; });
    regionOf_.assign(found.size(), kNone);
    for (const auto n : roots) {
      regionOf_[n] = static_cast<std::uint32_t>(owner_.regions_.size());
      owner_.regions_.push_back(found[n]);
    }
    for (std::uint32_t n = 0; n < found.size(); ++n) regionOf_[n] = regionOf_[sets_.find(n)];
    owner_.ofPiece_.assign(regionOf_.begin(),
                           regionOf_.begin() + static_cast<std::ptrdiff_t>(pieces_));
  }

  CutRegions& owner_;
  std::size_t pieces_ = 0;
  detail::DisjointSets sets_;
  std::vector<char> goesOn_;  // by node
  std::vector<std::uint32_t> regionOf_;
};

CutRegions::CutRegions(const CutCells& cells) {
  Builder(*this).build(cells);
}

template <std::floating_point T>
CutRegions::CutRegions(const CutLeaves& leaves, const OctreeCells<T>& mesh) {
  require(leaves.classes.size() == mesh.cells().size(), "CutRegions: need the mesh of these leaves",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  Builder(*this).build(leaves, LeafGrid(mesh, CutFrame{}));
}

std::uint32_t CutRegions::ofCell(const Index3& cell) const {
  const auto number = numberIn(box_, cell);
  const auto after = std::ranges::upper_bound(runs_, number, {}, &Run::first);
  return after != runs_.begin() && number < (after - 1)->last ? (after - 1)->region : kNone;
}

template CutRegions::CutRegions(const CutLeaves&, const OctreeCells<float>&);
template CutRegions::CutRegions(const CutLeaves&, const OctreeCells<double>&);

}  // namespace cutwater
