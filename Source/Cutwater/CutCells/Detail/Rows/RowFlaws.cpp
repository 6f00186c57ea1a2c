#include <Cutwater/CutCells/Detail/Rows/RowFlaws.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace cutwater {

namespace {

constexpr auto kMost = std::int64_t{std::numeric_limits<std::int32_t>::max()};

auto placeInOrder(const Index3& index) {
  return std::tuple(index.k, index.j, index.i);
}

bool areFinite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double v) { return std::isfinite(v); });
}
bool areFinite(const std::vector<Vec3<double>>& vectors) {
  return std::ranges::all_of(vectors, [](const Vec3<double>& v) { return isFinite(v); });
}

template <typename... Arrays>
bool areAsLong(std::size_t count, const Arrays&... arrays) {
  return ((arrays.size() == count) && ...);
}

/// Numbers of what follows, from 0 up to as many as there are.
template <typename Number>
bool areStarts(const std::vector<Number>& first, std::size_t rows, std::size_t end) {
  return first.size() == rows + 1 && first.front() == 0 && first.back() == end &&
         std::ranges::is_sorted(first);
}

bool isGrid(const CellPlanes& grid) {
  double count = 1;
  const std::array first{grid.first.i, grid.first.j, grid.first.k};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& planes = grid.planes[axis];
    if (planes.size() < 4 || !areFinite(planes)) return false;
    if (std::ranges::adjacent_find(planes, std::greater_equal()) != planes.end()) return false;
    // Cells around the box have indices, too.
    const auto last = std::int64_t{first[axis]} + static_cast<std::int64_t>(planes.size()) - 3;
    if (first[axis] == std::numeric_limits<std::int32_t>::min() || last > kMost) return false;
    count *= static_cast<double>(planes.size());
  }
  return count < 0x1p62;
}

class Rows {
 public:
  explicit Rows(const CutCells& cells) : cells_(cells), box_(cells.grid.indices()) {
    const auto& [lo, hi] = box_;
    around_ = {{lo.i - 1, lo.j - 1, lo.k - 1}, {hi.i + 1, hi.j + 1, hi.k + 1}};
  }

  [[nodiscard]] const char* flaw() const {
    if (!areCells()) return "its cells are not those of a grid, in order";
    if (!areBodyRuns()) return "its runs of cells without fluid are none";
    if (!arePieces()) return "its pieces do not belong to its cells";
    if (!areArcs()) return "its arcs do not lie between its pieces";
    if (!areWallParts()) return "its walls do not belong to its pieces";
    if (!areMoments()) return "its moments do not belong to its pieces and arcs";
    if (!arePolygons()) return "its polygons do not belong to its arcs and walls";
    return nullptr;
  }

 private:
  /// Those of the box, and then those around it.
  [[nodiscard]] bool areCells() const {
    const auto& [index, firstPiece, fluidCorners, meets] = cells_.cells;
    if (cells_.cellCount > index.size() || !areAsLong(index.size(), fluidCorners, meets)) {
      return false;
    }
    if (!areStarts(firstPiece, index.size(), cells_.pieces.cell.size())) return false;
    for (std::size_t row = 0; row < index.size(); ++row) {
      const bool isOwn = row < cells_.cellCount;
      if (box_.contains(index[row]) != isOwn || !around_.contains(index[row])) return false;
      if (row == 0 || row == cells_.cellCount) continue;
      if (!(placeInOrder(index[row - 1]) < placeInOrder(index[row]))) return false;
    }
    return true;
  }
  [[nodiscard]] bool areBodyRuns() const {
    std::uint64_t end = 0;
    for (const auto& [first, last] : cells_.bodyRuns) {
      if (first < end || last <= first) return false;
      end = last;
    }
    return end <= box_.count();
  }
  [[nodiscard]] bool arePieces() const {
    const auto& [cell, volume, centroid, wallArea, wallVector, wallCentroid] = cells_.pieces;
    const auto& first = cells_.cells.firstPiece;
    if (cells_.pieceCount != first[cells_.cellCount]) return false;
    if (!areAsLong(cell.size(), volume, centroid, wallArea, wallVector, wallCentroid)) return false;
    for (std::size_t row = 0; row + 1 < first.size(); ++row) {
      for (auto p = first[row]; p < first[row + 1]; ++p) {
        if (cell[p] != row) return false;
      }
    }
    return areFinite(volume) && areFinite(centroid) && areFinite(wallArea) &&
           areFinite(wallVector) && areFinite(wallCentroid);
  }
  [[nodiscard]] bool areArcs() const {
    const auto& [below, above, area, centroid, cell, axis] = cells_.arcs;
    if (!areAsLong(area.size(), below, above, centroid, cell, axis)) return false;
    const auto key = [&arcs = cells_.arcs](std::size_t a) {
      return std::tuple(placeInOrder(arcs.cell[a]), arcs.axis[a]);
    };
    std::size_t open = 0;  // of those of open patches
    for (std::size_t a = 0; a < area.size(); ++a) {
      if (axis[a] > 2 || !around_.contains(cell[a])) return false;
      const auto under = cells_.arcs.cellBelow(a);
      if (!box_.contains(cell[a]) && !box_.contains(under)) return false;
      const bool isOpen = open < cells_.openArcs.arc.size() && cells_.openArcs.arc[open] == a;
      if (isOpen && !leadsOut(below[a], above[a]) && !leadsOut(above[a], below[a])) return false;
      if (isOpen) ++open;
      if (!isBeside(below[a], under, isOpen) || !isBeside(above[a], cell[a], isOpen)) return false;
      if (a > 0 && key(a) < key(a - 1)) return false;
    }
    return open == cells_.openArcs.arc.size() && areAsLong(open, cells_.openArcs.patch) &&
           arePatches(cells_.openArcs.patch) && areFinite(area) && areFinite(centroid);
  }
  /// From a piece of the box.
  [[nodiscard]] bool leadsOut(std::uint32_t side, std::uint32_t other) const {
    return side == CutCells::kBeyond && other < cells_.pieceCount;
  }
  [[nodiscard]] bool arePatches(const std::vector<std::uint32_t>& numbers) const {
    const auto count = cells_.patchNames.size();
    return std::ranges::all_of(numbers, [=](auto patch) { return patch < count; });
  }
  /// Whether a side of an arc can be what lies in the cell there. What is beyond an open patch can
  /// be anywhere.
  [[nodiscard]] bool isBeside(std::uint32_t side, const Index3& cell, bool isOpen) const {
    const auto& owner = cells_.pieces.cell;
    if (side < owner.size()) return cells_.cells.index[owner[side]] == cell;
    const bool isInBox = box_.contains(cell);
    if (side == CutCells::kBeyond) return isOpen || !isInBox;
    if (side != CutCells::kWholeCell) return false;
    return !isInBox || cells_.classOf(cell) == FluidClass::Fluid;
  }
  [[nodiscard]] bool areWallParts() const {
    const auto& [piece, patch, area, vector, centroid] = cells_.wallParts;
    if (!areAsLong(piece.size(), patch, area, vector, centroid)) return false;
    if (!std::ranges::is_sorted(piece)) return false;
    if (!piece.empty() && piece.back() >= cells_.pieces.cell.size()) return false;
    return arePatches(patch) && areFinite(area) && areFinite(vector) && areFinite(centroid);
  }
  [[nodiscard]] bool areMoments() const {
    const auto& moments = cells_.moments;
    const auto& [degree, volume, wall, wallVector, arc] = moments;
    if (degree < -1 || degree > CutCells::Moments::kHighest) return false;
    const auto pieces = degree < 0 ? 0 : moments.perPiece() * cells_.pieces.cell.size();
    const auto arcs = degree < 0 ? 0 : moments.perArc() * cells_.arcs.area.size();
    return areAsLong(pieces, volume, wall, wallVector) && areAsLong(arcs, arc) &&
           areFinite(volume) && areFinite(wall) && areFinite(wallVector) && areFinite(arc);
  }
  [[nodiscard]] bool arePolygons() const {
    const auto& arcs = cells_.arcPolygons;
    const auto& walls = cells_.wallPolygons;
    for (const auto* polygons : {&arcs, &walls}) {
      const auto& [first, points] = *polygons;
      if (first.empty() || !areStarts(first, polygons->count(), points.size())) return false;
      if (!areFinite(points)) return false;
    }
    const auto& first = cells_.firstWallPolygon;
    if (first.empty()) return arcs.count() == 0 && walls.count() == 0;
    return arcs.count() == cells_.arcs.area.size() &&
           areStarts(first, cells_.wallParts.piece.size(), walls.count());
  }

  const CutCells& cells_;
  IndexBox box_;
  IndexBox around_;
};

}  // namespace

const char* flawOf(const CutCells& cells) {
  if (!isGrid(cells.grid)) return "its planes are not those of a grid";
  return Rows(cells).flaw();
}

}  // namespace cutwater
