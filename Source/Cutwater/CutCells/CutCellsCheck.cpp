#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/MomentClosure.hpp>

#include <algorithm>

namespace cutwater {

namespace {

constexpr double kSlack = 1e-12;  // of a cell's size

double largestFace(const CutCells& cells, const Index3& cell) {
  return std::max({cells.faceArea(cell, 0), cells.faceArea(cell, 1), cells.faceArea(cell, 2)});
}

bool isIn(const Box<double>& box, const Vec3<double>& p) {
  const auto slack =
      kSlack * (box.upper - box.lower) + 0x1p-50 * max(abs(box.lower), abs(box.upper));
  const auto gaps = max(box.lower - slack - p, p - box.upper - slack);
  return maxComponent(gaps) <= 0;
}

/// Whether a piece, or what stands in its place, can lie in a cell.
bool canBeIn(const CutCells& cells, const Index3& cell, std::uint32_t piece) {
  if (piece < cells.pieces.cell.size()) {
    return cells.cells.index[cells.pieces.cell[piece]] == cell;
  }
  const bool isInBox = cells.grid.indices().contains(cell);
  if (piece == CutCells::kBeyond) return !isInBox;
  return piece == CutCells::kWholeCell && (!isInBox || cells.classOf(cell) == FluidClass::Fluid);
}

/// What closes each piece: the sum of its wall's and its apertures' vectors.
void checkClosure(const CutCells& cells, CutCellsReport& report) {
  auto sums = cells.pieces.wallVector;
  std::vector<char> isBounded(sums.size());
  for (std::size_t p = 0; p < sums.size(); ++p) isBounded[p] = cells.pieces.wallArea[p] > 0 ? 1 : 0;
  const auto& arcs = cells.arcs;
  for (std::size_t a = 0; a < arcs.area.size(); ++a) {
    for (const bool isBelow : {true, false}) {
      const auto piece = isBelow ? arcs.below[a] : arcs.above[a];
      const auto cell = isBelow ? arcs.cellBelow(a) : arcs.cell[a];
      if (!canBeIn(cells, cell, piece)) ++report.lostPieces;
      if (piece >= sums.size()) continue;
      sums[piece][arcs.axis[a]] += isBelow ? arcs.area[a] : -arcs.area[a];
      isBounded[piece] = 1;
    }
  }
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    if (isBounded[p] == 0) ++report.lostPieces;
    const auto& cell = cells.cells.index[cells.pieces.cell[p]];
    report.worstClosure = std::max(report.worstClosure, length(sums[p]) / largestFace(cells, cell));
  }
}

void checkRanges(const CutCells& cells, CutCellsReport& report) {
  const auto& pieces = cells.pieces;
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const auto& cell = cells.cells.index[row];
    const auto box = cells.boxOf(cell);
    const double volume = cells.cellVolume(cell);
    double fluid = 0;
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      const bool isRight = pieces.volume[p] >= 0 && isIn(box, pieces.centroid[p]) &&
                           isIn(box, pieces.wallCentroid[p]);
      if (!isRight) ++report.outOfRange;
      fluid += pieces.volume[p];
    }
    if (!(fluid <= volume * (1 + kSlack))) ++report.outOfRange;
    if (cells.cells.isThin(row)) ++report.thinCells;
    if (cells.cells.meets[row] != 0) ++report.meetingCells;
    if (cells.cells.firstPiece[row + 1] > cells.cells.firstPiece[row] + 1) ++report.multiPieceCells;
  }
  const auto& arcs = cells.arcs;
  for (std::size_t a = 0; a < arcs.area.size(); ++a) {
    const double face = cells.faceArea(arcs.cell[a], arcs.axis[a]);
    if (!(arcs.area[a] >= 0 && arcs.area[a] <= face * (1 + kSlack))) ++report.outOfRange;
  }
}

/// The volume of the cells that are not cut and have no fluid.
double wholeBodyVolume(const CutCells& cells) {
  const auto box = cells.grid.indices();
  const auto nx = box.length(0);
  const auto ny = box.length(1);
  if (nx == 0 || ny == 0) return 0;
  DoubleDouble sum;
  for (const auto& [first, last] : cells.bodyRuns) {
    for (auto n = first; n < last; ++n) {
      const auto i = n % nx;
      const auto j = n / nx % ny;
      const auto k = n / nx / ny;
      const auto cell = box.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                               static_cast<std::uint32_t>(k));
      if (cells.rowOf(cell) == CutCells::kNoRow) sum += cells.cellVolume(cell);
    }
  }
  return static_cast<double>(sum);
}

/// Whether a piece, or what stands in its place, can lie in a leaf.
bool canBeIn(const CutLeaves& leaves, std::uint32_t leaf, std::uint32_t piece) {
  if (piece < leaves.pieces.cell.size()) return leaves.cut.leaf[leaves.pieces.cell[piece]] == leaf;
  if (piece == CutLeaves::kBeyond) return leaf == CutLeaves::kNoLeaf;
  return piece == CutLeaves::kWholeCell && leaves.classes[leaf] == FluidClass::Fluid;
}

void checkClosure(const CutLeaves& leaves, CutCellsReport& report) {
  auto sums = leaves.pieces.wallVector;
  std::vector<char> isBounded(sums.size());
  for (std::size_t p = 0; p < sums.size(); ++p) {
    isBounded[p] = leaves.pieces.wallArea[p] > 0 ? 1 : 0;
  }
  const auto& arcs = leaves.arcs;
  for (std::size_t a = 0; a < arcs.area.size(); ++a) {
    for (const bool isBelow : {true, false}) {
      const auto piece = isBelow ? arcs.below[a] : arcs.above[a];
      const auto leaf = isBelow ? arcs.leafBelow[a] : arcs.leafAbove[a];
      if (!canBeIn(leaves, leaf, piece)) ++report.lostPieces;
      if (piece >= sums.size()) continue;
      sums[piece][arcs.axis[a]] += isBelow ? arcs.area[a] : -arcs.area[a];
      isBounded[piece] = 1;
    }
    if (!(arcs.area[a] >= 0 && arcs.area[a] <= arcs.faceArea[a] * (1 + kSlack))) {
      ++report.outOfRange;
    }
  }
  for (std::size_t p = 0; p < sums.size(); ++p) {
    if (isBounded[p] == 0) ++report.lostPieces;
    const auto& box = leaves.cut.box[leaves.pieces.cell[p]];
    const auto size = box.upper - box.lower;
    const double face = std::max({size.x * size.y, size.y * size.z, size.z * size.x});
    report.worstClosure = std::max(report.worstClosure, length(sums[p]) / face);
  }
}

}  // namespace

CutCellsReport check(const CutLeaves& leaves) {
  CutCellsReport report{.cutCells = leaves.cut.leaf.size()};
  const auto& pieces = leaves.pieces;
  DoubleDouble allFluid;
  DoubleDouble cutVolume;
  DoubleDouble wall;
  for (std::uint32_t row = 0; row < report.cutCells; ++row) {
    const double volume = leaves.leafVolume(row);
    const auto first = leaves.cut.firstPiece[row];
    const auto last = leaves.cut.firstPiece[row + 1];
    double fluid = 0;
    for (auto p = first; p < last; ++p) {
      const bool isRight = pieces.volume[p] >= 0 && isIn(leaves.cut.box[row], pieces.centroid[p]) &&
                           isIn(leaves.cut.box[row], pieces.wallCentroid[p]);
      if (!isRight) ++report.outOfRange;
      fluid += pieces.volume[p];
      allFluid += pieces.volume[p];
      wall += pieces.wallArea[p];
    }
    cutVolume += volume;
    if (!(fluid <= volume * (1 + kSlack))) ++report.outOfRange;
    const auto corners = leaves.cut.fluidCorners[row];
    if (corners == 0 || corners == 0xff) ++report.thinCells;
    if (last > first + 1) ++report.multiPieceCells;
  }
  report.fluidVolume = static_cast<double>(allFluid + DoubleDouble(leaves.wholeFluid));
  report.bodyVolume = static_cast<double>(cutVolume - allFluid) + leaves.wholeBody;
  report.wallArea = static_cast<double>(wall);
  checkClosure(leaves, report);
  return report;
}

CutCellsReport check(const CutCells& cells) {
  CutCellsReport report{.cutCells = cells.cellCount};
  DoubleDouble cutVolume;
  DoubleDouble cutFluid;
  DoubleDouble wall;
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    cutVolume += cells.cellVolume(cells.cells.index[row]);
  }
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    cutFluid += cells.pieces.volume[p];
    wall += cells.pieces.wallArea[p];
  }
  const auto& planes = cells.grid.planes;
  double all = 1;
  for (const auto& axis : planes) all *= axis[axis.size() - 2] - axis[1];
  report.bodyVolume = wholeBodyVolume(cells) + static_cast<double>(cutVolume - cutFluid);
  report.fluidVolume = all - report.bodyVolume;
  report.wallArea = static_cast<double>(wall);
  checkClosure(cells, report);
  checkRanges(cells, report);
  report.worstMoments = worstMoments(cells);
  return report;
}

}  // namespace cutwater
