#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>
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
    if (grid.period[axis] < 0) return false;
    if (planes.size() < 4 || !areFinite(planes)) return false;
    if (std::ranges::adjacent_find(planes, std::greater_equal()) != planes.end()) return false;
    // Cells around the box have indices, too.
    const auto last = std::int64_t{first[axis]} + static_cast<std::int64_t>(planes.size()) - 3;
    if (first[axis] == std::numeric_limits<std::int32_t>::min() || last > kMost) return false;
    count *= static_cast<double>(planes.size());
  }
  return count < 0x1p62;
}

/// Whether pieces are those of their cells, in order.
template <typename Cut>
bool arePieces(const Cut& cut) {
  const auto& [cell, volume, centroid, wallArea, wallVector, wallCentroid, wallFaces] = cut.pieces;
  const auto& first = rowsOf(cut).firstPiece;
  if (!areAsLong(cell.size(), volume, centroid, wallArea, wallVector, wallCentroid, wallFaces)) {
    return false;
  }
  for (std::size_t row = 0; row + 1 < first.size(); ++row) {
    std::uint8_t faces = 0;
    for (auto p = first[row]; p < first[row + 1]; ++p) {
      if (cell[p] != row) return false;
      faces |= wallFaces[p];
    }
    if (rowsOf(cut).wallFaces[row] != faces || faces >= 1U << 6U) return false;
  }
  return areFinite(volume) && areFinite(centroid) && areFinite(wallArea) && areFinite(wallVector) &&
         areFinite(wallCentroid);
}

template <typename Cut>
bool arePatches(const Cut& cut, const std::vector<std::uint32_t>& numbers) {
  const auto count = cut.patchNames.size();
  return std::ranges::all_of(numbers, [=](auto patch) { return patch < count; });
}

/// What OpenArcs::patchOf() relies on, and so all that asks what lies beside an arc.
bool areInOrder(const CutCells::OpenArcs& open) {
  return std::ranges::adjacent_find(open.arc, std::greater_equal()) == open.arc.end();
}

/// Whether those of open patches lead out of one of the first pieces.
template <typename Cut>
bool areOpenArcs(const Cut& cut, std::size_t pieceCount) {
  const auto& [arcs, patches] = cut.openArcs;
  if (!areAsLong(arcs.size(), patches) || !arePatches(cut, patches)) return false;
  if (!arcs.empty() && arcs.back() >= cut.arcs.area.size()) return false;
  return std::ranges::all_of(arcs, [&](std::uint32_t arc) {
    const auto [outer, inner] =
        std::minmax(cut.arcs.below[arc], cut.arcs.above[arc], std::greater());
    return outer == CutCells::kBeyond && inner < pieceCount;
  });
}

template <typename Cut>
bool areWallParts(const Cut& cut) {
  const auto& [piece, patch, area, vector, centroid] = cut.wallParts;
  if (!areAsLong(piece.size(), patch, area, vector, centroid)) return false;
  if (!std::ranges::is_sorted(piece)) return false;
  if (!piece.empty() && piece.back() >= cut.pieces.cell.size()) return false;
  return arePatches(cut, patch) && areFinite(area) && areFinite(vector) && areFinite(centroid);
}

template <typename Cut>
bool areMoments(const Cut& cut) {
  const auto& moments = cut.moments;
  const auto& [degree, volume, wall, wallVector, arc] = moments;
  if (degree < -1 || degree > CutCells::Moments::kHighest) return false;
  const auto pieces = degree < 0 ? 0 : moments.perPiece() * cut.pieces.cell.size();
  const auto arcs = degree < 0 ? 0 : moments.perArc() * cut.arcs.area.size();
  return areAsLong(pieces, volume, wall, wallVector) && areAsLong(arcs, arc) && areFinite(volume) &&
         areFinite(wall) && areFinite(wallVector) && areFinite(arc);
}

template <typename Cut>
bool arePolygons(const Cut& cut) {
  const auto& arcs = cut.arcPolygons;
  const auto& walls = cut.wallPolygons;
  for (const auto* polygons : {&arcs, &walls}) {
    const auto& [first, points] = *polygons;
    if (first.empty() || !areStarts(first, polygons->count(), points.size())) return false;
    if (!areFinite(points)) return false;
  }
  const auto& first = cut.firstWallPolygon;
  if (first.empty()) return arcs.count() == 0 && walls.count() == 0;
  return arcs.count() == cut.arcs.area.size() &&
         areStarts(first, cut.wallParts.piece.size(), walls.count());
}

template <typename Cut>
bool areQuadratures(const Cut& cut) {
  const auto& [ofVolumes, ofWalls, wallNormals, ofArcs] = cut.quadrature;
  const auto areRows = [](const CutCells::PointRows& rows, std::size_t count) {
    const auto& [first, points, weights] = rows;
    if (points.size() != weights.size() || !areFinite(points) || !areFinite(weights)) return false;
    return first.empty() ? points.empty() : areStarts(first, count, points.size());
  };
  const auto pieces = cut.pieces.cell.size();
  return areRows(ofVolumes, pieces) && areRows(ofWalls, pieces) &&
         areRows(ofArcs, cut.arcs.area.size()) && wallNormals.size() == ofWalls.points.size() &&
         areFinite(wallNormals);
}

/// What of an arc, whose cells are some, lies beside it.
template <typename Cut>
bool areBeside(const Cut& cut, std::size_t arc) {
  return canBeBeside(cut, arc, true, cut.arcs.below[arc]) &&
         canBeBeside(cut, arc, false, cut.arcs.above[arc]);
}

class CellRows {
 public:
  explicit CellRows(const CutCells& cells) : cells_(cells), box_(cells.grid.indices()) {
    const auto& [lo, hi] = box_;
    around_ = {{lo.i - 1, lo.j - 1, lo.k - 1}, {hi.i + 1, hi.j + 1, hi.k + 1}};
  }

  [[nodiscard]] const char* flaw() const {
    if (!areCells()) return "its cells are not those of a grid, in order";
    if (!areBodyRuns()) return "its runs of cells without fluid are none";
    if (!hasItsPieces() || !arePieces(cells_)) return "its pieces do not belong to its cells";
    const char* const openFlaw = "its open patches are not those of arcs";
    if (!areInOrder(cells_.openArcs)) return openFlaw;
    if (!areArcs()) return "its arcs do not lie between its pieces";
    if (!areOpenArcs(cells_, cells_.pieceCount)) return openFlaw;
    if (!areWallParts(cells_)) return "its walls do not belong to its pieces";
    if (!areMoments(cells_)) return "its moments do not belong to its pieces and arcs";
    if (!arePolygons(cells_)) return "its polygons do not belong to its arcs and walls";
    if (!areQuadratures(cells_))
      return "its points of quadrature do not belong to its pieces and arcs";
    return nullptr;
  }

 private:
  /// Those of the box, and then those around it.
  [[nodiscard]] bool areCells() const {
    const auto& [index, firstPiece, fluidCorners, meets, wallFaces, error] = cells_.cells;
    if (cells_.cellCount > index.size()) return false;
    if (!areAsLong(index.size(), fluidCorners, meets, wallFaces)) return false;
    if (!error.empty() && error.size() != index.size()) return false;
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
  [[nodiscard]] bool hasItsPieces() const {
    return cells_.pieceCount == cells_.cells.firstPiece[cells_.cellCount];
  }
  [[nodiscard]] bool areArcs() const {
    const auto& [below, above, area, centroid, cell, axis] = cells_.arcs;
    if (!areAsLong(area.size(), below, above, centroid, cell, axis)) return false;
    const auto key = [&arcs = cells_.arcs](std::size_t a) {
      return std::tuple(placeInOrder(arcs.cell[a]), arcs.axis[a]);
    };
    for (std::size_t a = 0; a < area.size(); ++a) {
      if (axis[a] > 2 || !around_.contains(cell[a])) return false;
      const auto under = cells_.arcs.cellBelow(a);
      if (!box_.contains(cell[a]) && !box_.contains(under)) return false;
      if (!areBeside(cells_, a)) return false;
      if (a > 0 && key(a) < key(a - 1)) return false;
    }
    return areFinite(area) && areFinite(centroid);
  }

  const CutCells& cells_;
  IndexBox box_;
  IndexBox around_;
};

class LeafRows {
 public:
  explicit LeafRows(const CutLeaves& leaves) : leaves_(leaves) {}

  [[nodiscard]] const char* flaw() const {
    if (!areClasses()) return "its classes are not those of leaves";
    if (!areLeaves()) return "its leaves are not those that are cut, in order";
    if (!arePieces(leaves_)) return "its pieces do not belong to its leaves";
    const char* const openFlaw = "its open patches are not those of arcs";
    if (!areInOrder(leaves_.openArcs)) return openFlaw;
    if (!areArcs()) return "its arcs do not lie between its pieces";
    if (!areOpenArcs(leaves_, leaves_.pieces.cell.size())) return openFlaw;
    if (!areWallParts(leaves_)) return "its walls do not belong to its pieces";
    if (!areMoments(leaves_)) return "its moments do not belong to its pieces and arcs";
    if (!arePolygons(leaves_)) return "its polygons do not belong to its arcs and walls";
    if (!areQuadratures(leaves_))
      return "its points of quadrature do not belong to its pieces and arcs";
    return nullptr;
  }

 private:
  [[nodiscard]] bool areClasses() const {
    const auto& classes = leaves_.classes;
    if (classes.size() >= CutLeaves::kNoLeaf) return false;
    // Where there are none, they have no volume.
    const auto isVolume = [&](double volume, FluidClass of) {
      return std::isfinite(volume) && volume >= 0 &&
             (volume == 0 || std::ranges::find(classes, of) != classes.end());
    };
    return std::ranges::all_of(classes, [](FluidClass it) { return it < FluidClass::Unknown; }) &&
           isVolume(leaves_.wholeFluid, FluidClass::Fluid) &&
           isVolume(leaves_.wholeBody, FluidClass::Body);
  }
  [[nodiscard]] bool areLeaves() const {
    const auto& [leaf, box, firstPiece, fluidCorners, meets, wallFaces, error] = leaves_.cut;
    const auto& classes = leaves_.classes;
    if (!areAsLong(leaf.size(), box, fluidCorners, meets, wallFaces)) return false;
    if (!error.empty() && error.size() != leaf.size()) return false;
    if (!areStarts(firstPiece, leaf.size(), leaves_.pieces.cell.size())) return false;
    if (std::ranges::adjacent_find(leaf, std::greater_equal()) != leaf.end()) return false;
    if (std::ranges::count(classes, FluidClass::Cut) != std::ssize(leaf)) return false;
    for (std::size_t row = 0; row < leaf.size(); ++row) {
      const auto& [lower, upper] = box[row];
      if (leaf[row] >= classes.size() || classes[leaf[row]] != FluidClass::Cut) return false;
      if (!isFinite(lower) || !isFinite(upper) || !(maxComponent(lower - upper) < 0)) return false;
    }
    return true;
  }
  [[nodiscard]] bool areArcs() const {
    const auto& [below, above, leafBelow, leafAbove, area, centroid, faceArea, axis] = leaves_.arcs;
    if (!areAsLong(area.size(), below, above, leafBelow, leafAbove, centroid, faceArea, axis)) {
      return false;
    }
    Place last{};
    for (std::size_t a = 0; a < area.size(); ++a) {
      if (axis[a] > 2 || !isLeaf(leafBelow[a]) || !isLeaf(leafAbove[a])) return false;
      if (leafBelow[a] == leafAbove[a] || !areBeside(leaves_, a) || !haveCommonFace(a)) {
        return false;
      }
      if (!isInOrder(a, last)) return false;
    }
    return areFinite(area) && areFinite(centroid) && areFinite(faceArea);
  }
  [[nodiscard]] bool isLeaf(std::uint32_t leaf) const {
    return leaf == CutLeaves::kNoLeaf || leaf < leaves_.classes.size();
  }
  /// At least one side of an arc is a piece; and if both are, their leaves touch.
  [[nodiscard]] bool haveCommonFace(std::size_t arc) const {
    const auto pieces = leaves_.pieces.cell.size();
    const auto below = leaves_.arcs.below[arc];
    const auto above = leaves_.arcs.above[arc];
    if (below >= pieces && above >= pieces) return false;
    if (below >= pieces || above >= pieces) return true;
    const auto& under = boxOfRow(leaves_, leaves_.pieces.cell[below]);
    const auto& over = boxOfRow(leaves_, leaves_.pieces.cell[above]);
    const int axis = leaves_.arcs.axis[arc];
    auto gap = max(under.lower, over.lower) - min(under.upper, over.upper);
    gap[axis] = -1;
    return under.upper[axis] == over.lower[axis] && maxComponent(gap) < 0;
  }

  /// By which arcs are sorted: the finer leaf, the axis, and whether it is a high face.
  using Place = std::tuple<std::uint32_t, std::uint8_t, bool>;
  /// Takes the next arc's place, the first one that it can have: which leaf is the finer one is not
  /// known, nor where in the order leaves of other ranks are.
  [[nodiscard]] bool isInOrder(std::size_t arc, Place& last) const {
    const auto& arcs = leaves_.arcs;
    if (arcs.leafBelow[arc] == CutLeaves::kNoLeaf || arcs.leafAbove[arc] == CutLeaves::kNoLeaf) {
      return true;
    }
    const Place ofBelow{arcs.leafBelow[arc], arcs.axis[arc], true};
    const Place ofAbove{arcs.leafAbove[arc], arcs.axis[arc], false};
    const auto& [first, second] = std::minmax(ofBelow, ofAbove);
    if (second < last) return false;
    last = first < last ? second : first;
    return true;
  }

  const CutLeaves& leaves_;
};

}  // namespace

const char* flawOf(const CutCells& cells) {
  if (!isGrid(cells.grid)) return "its planes are not those of a grid";
  return CellRows(cells).flaw();
}

const char* flawOf(const CutLeaves& leaves) {
  return LeafRows(leaves).flaw();
}

}  // namespace cutwater
