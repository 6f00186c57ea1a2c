#include <Cutwater/CutCells/Detail/Rows/PeriodicRows.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

auto orderOfCell(const Index3& cell) {
  return std::tuple(cell.k, cell.j, cell.i);
}

/// The lowest plane of the box across an axis, and the highest.
std::array<double, 2> endsOf(const CellPlanes& grid, std::size_t axis) {
  const auto& planes = grid.planes[axis];
  return {planes[1], planes[planes.size() - 2]};
}

/// An arc in another place, or between other pieces.
struct ChangedArc {
  std::uint32_t source = 0;
  Index3 cell;
  std::uint8_t axis = 0;
  std::uint32_t below = 0;
  std::uint32_t above = 0;
  double plane = 0;

  [[nodiscard]] auto key() const { return std::pair(orderOfCell(cell), axis); }
};

/// In the order of arcs.
void replaceArcs(CutCells& cells, std::vector<ChangedArc> changed) {
  std::ranges::stable_sort(changed, {}, &ChangedArc::key);
  CutCells::Arcs arcs;
  CutCells::OpenArcs openArcs;
  std::vector<double> moments;
  for (const auto& [source, cell, axis, below, above, plane] : changed) {
    if (const auto patch = cells.openArcs.patchOf(source); patch != CutCells::kNoRow) {
      openArcs.arc.push_back(static_cast<std::uint32_t>(arcs.area.size()));
      openArcs.patch.push_back(patch);
    }
    arcs.below.push_back(below);
    arcs.above.push_back(above);
    arcs.area.push_back(cells.arcs.area[source]);
    arcs.centroid.push_back(cells.arcs.centroid[source]);
    arcs.centroid.back()[axis] = plane;
    arcs.cell.push_back(cell);
    arcs.axis.push_back(axis);
    if (cells.moments.degree < 0) continue;
    const auto row = cells.moments.ofArc(source);
    moments.insert(moments.end(), row.begin(), row.end());
  }
  cells.arcs = std::move(arcs);
  cells.openArcs = std::move(openArcs);
  cells.moments.arc = std::move(moments);
}

ChangedArc unchangedArc(const CutCells& cells, std::uint32_t arc) {
  const auto& arcs = cells.arcs;
  return {arc,
          arcs.cell[arc],
          arcs.axis[arc],
          arcs.below[arc],
          arcs.above[arc],
          arcs.centroid[arc][arcs.axis[arc]]};
}

/// Adds copies of cells of the box beyond it.
class RowsBeyond {
 public:
  RowsBeyond(CutCells& cells, const SpannedAxes& spanned) : cells_(cells), spanned_(spanned) {}

  /// Notes that a piece of the box is wanted in a cell beyond it.
  void want(const Index3& cell) { firstPiece_.try_emplace(orderOfCell(cell), 0); }
  /// All that are wanted, in order.
  void add() {
    for (auto& [place, first] : firstPiece_) {
      const auto& [k, j, i] = place;
      first = static_cast<std::uint32_t>(cells_.pieces.volume.size());
      addRow({i, j, k});
    }
  }
  /// Its row, once they are there.
  [[nodiscard]] std::uint32_t pieceIn(const Index3& cell, std::uint32_t piece) const {
    const auto own = cells_.cells.firstPiece[cells_.pieces.cell[piece]];
    return firstPiece_.at(orderOfCell(cell)) + piece - own;
  }

 private:
  template <typename Value>
  static void copy(std::vector<Value>& values, std::size_t first, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) values.push_back(Value(values[first + n]));
  }

  void addRow(const Index3& cell) {
    auto& rows = cells_.cells;
    const auto own = cells_.rowOf(inPeriod(cells_.grid, spanned_, cell));
    const auto first = rows.firstPiece[own];
    const auto count = rows.firstPiece[own + 1] - first;
    const auto shift = cells_.boxOf(cell).lower - cells_.boxOf(rows.index[own]).lower;
    const auto row = static_cast<std::uint32_t>(rows.index.size());
    rows.index.push_back(cell);
    rows.firstPiece.push_back(rows.firstPiece.back() + count);
    copy(rows.fluidCorners, own, 1);
    copy(rows.meets, own, 1);
    copy(rows.wallFaces, own, 1);
    if (!rows.error.empty()) copy(rows.error, own, 1);
    auto& pieces = cells_.pieces;
    copy(pieces.volume, first, count);
    copy(pieces.wallArea, first, count);
    copy(pieces.wallVector, first, count);
    copy(pieces.wallFaces, first, count);
    for (auto p = first; p < first + count; ++p) {
      pieces.cell.push_back(row);
      pieces.centroid.push_back(pieces.centroid[p] + shift);
      pieces.wallCentroid.push_back(pieces.wallCentroid[p] + shift);
      addWallParts(p, static_cast<std::uint32_t>(pieces.cell.size() - 1), shift);
    }
    auto& moments = cells_.moments;
    if (moments.degree < 0) return;
    const auto per = moments.perPiece();
    copy(moments.volume, per * first, per * count);
    copy(moments.wall, per * first, per * count);
    copy(moments.wallVector, per * first, per * count);
  }
  void addWallParts(std::uint32_t from, std::uint32_t to, const Vec3<double>& shift) {
    auto& parts = cells_.wallParts;
    const auto first = std::ranges::lower_bound(parts.piece, from) - parts.piece.begin();
    for (auto n = static_cast<std::size_t>(first); n < parts.piece.size(); ++n) {
      if (parts.piece[n] != from) break;
      parts.piece.push_back(to);
      copy(parts.patch, n, 1);
      copy(parts.area, n, 1);
      copy(parts.vector, n, 1);
      parts.centroid.push_back(parts.centroid[n] + shift);
    }
  }

  CutCells& cells_;
  const SpannedAxes& spanned_;
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, std::uint32_t> firstPiece_;
};

}  // namespace

SpannedAxes spannedAxes(const CellPlanes& grid) {
  SpannedAxes result{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto cells = static_cast<std::int64_t>(grid.planes[a].size()) - 3;
    result[a] = grid.period[a] > 0 && grid.period[a] == cells;
  }
  return result;
}

Index3 inPeriod(const CellPlanes& grid, const SpannedAxes& spanned, Index3 cell) {
  const auto [lo, hi] = grid.indices();
  for (std::size_t a = 0; a < 3; ++a) {
    auto& at = along(cell, a);
    if (!spanned[a]) continue;
    if (at < along(lo, a)) {
      at = along(hi, a);
    } else if (at > along(hi, a)) {
      at = along(lo, a);
    }
  }
  return cell;
}

std::uint32_t sideInPeriod(const CutCells& cells, const SpannedAxes& spanned, const Index3& cell,
                           std::uint32_t side) {
  const auto there = inPeriod(cells.grid, spanned, cell);
  if (there == cell || side < cells.pieceCount || side == CutCells::kBeyond) return side;
  if (side == CutCells::kWholeCell) {
    return cells.classOf(there) == FluidClass::Fluid ? side : CutCells::kBeyond;
  }
  const auto own = cells.rowOf(there);
  if (own == CutCells::kNoRow) return CutCells::kBeyond;
  const auto first = cells.cells.firstPiece[cells.pieces.cell[side]];
  const auto same = cells.cells.firstPiece[own] + (side - first);
  return same < cells.cells.firstPiece[own + 1] ? same : CutCells::kBeyond;
}

CutCells withJoinedEnds(const CutCells& cells, const SpannedAxes& spanned) {
  auto result = cells;
  result.arcPolygons = result.wallPolygons = {};
  result.firstWallPolygon.clear();
  const auto [lo, hi] = cells.grid.indices();
  std::vector<ChangedArc> joined;
  for (std::uint32_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    auto it = unchangedArc(cells, arc);
    const std::size_t a = it.axis;
    if (spanned[a] && along(it.cell, a) > along(hi, a)) {
      // Arcs between two pieces, and those below a piece, are at the low end as well.
      if (it.above < cells.pieces.cell.size()) continue;
      it.above = sideInPeriod(cells, spanned, it.cell, it.above);
      along(it.cell, a) = along(lo, a);
      it.plane = endsOf(cells.grid, a)[0];
    }
    it.below = sideInPeriod(cells, spanned, cells.arcs.cellBelow(arc), it.below);
    joined.push_back(it);
  }
  replaceArcs(result, std::move(joined));
  return result;
}

void separateEnds(CutCells& cells, const SpannedAxes& spanned) {
  const auto [lo, hi] = cells.grid.indices();
  RowsBeyond beyond(cells, spanned);
  const auto isPiece = [&](std::uint32_t side) { return side < cells.pieceCount; };
  std::vector<ChangedArc> separate;
  std::vector<std::pair<std::size_t, bool>> wanted;  // arcs whose side leads beyond, and which
  for (std::uint32_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    const auto it = unchangedArc(cells, arc);
    const std::size_t a = it.axis;
    auto place = it.cell;
    if (!spanned[a] || along(place, a) != along(lo, a)) {
      separate.push_back(it);
      continue;
    }
    if (isPiece(it.above)) {
      if (isPiece(it.below)) {
        beyond.want(cells.arcs.cellBelow(arc));
        wanted.emplace_back(separate.size(), true);
      }
      separate.push_back(it);
    }
    if (isPiece(it.below)) {
      auto high = it;
      along(high.cell, a) = along(hi, a) + 1;
      high.plane = endsOf(cells.grid, a)[1];
      if (isPiece(it.above)) {
        beyond.want(high.cell);
        wanted.emplace_back(separate.size(), false);
      }
      separate.push_back(high);
    }
  }
  beyond.add();
  for (const auto& [number, isBelow] : wanted) {
    auto& it = separate[number];
    auto cell = it.cell;
    if (isBelow) --along(cell, it.axis);
    auto& side = isBelow ? it.below : it.above;
    side = beyond.pieceIn(cell, side);
  }
  replaceArcs(cells, std::move(separate));
}

}  // namespace cutwater
