#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Moments/MomentClosure.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>

#include <algorithm>

namespace cutwater {

namespace {

constexpr double kSlack = 1e-12;  // of a cell's size

bool isIn(const Box<double>& box, const Vec3<double>& p) {
  const auto slack =
      kSlack * (box.upper - box.lower) + 0x1p-50 * max(abs(box.lower), abs(box.upper));
  const auto gaps = max(box.lower - slack - p, p - box.upper - slack);
  return maxComponent(gaps) <= 0;
}

/// What closes each piece: the sum of its wall's and its apertures' vectors.
template <typename Cut>
void checkClosure(const Cut& cut, CutCellsReport& report) {
  auto sums = cut.pieces.wallVector;
  std::vector<char> isBounded(sums.size());
  for (std::size_t p = 0; p < sums.size(); ++p) isBounded[p] = cut.pieces.wallArea[p] > 0 ? 1 : 0;
  const auto& arcs = cut.arcs;
  for (std::size_t a = 0; a < arcs.area.size(); ++a) {
    for (const bool isBelow : {true, false}) {
      const auto piece = isBelow ? arcs.below[a] : arcs.above[a];
      if (!canBeBeside(cut, a, isBelow, piece)) ++report.lostPieces;
      if (piece >= sums.size()) continue;
      sums[piece][arcs.axis[a]] += isBelow ? arcs.area[a] : -arcs.area[a];
      isBounded[piece] = 1;
    }
  }
  for (std::size_t p = 0; p < pieceCount(cut); ++p) {
    if (isBounded[p] == 0) ++report.lostPieces;
    const double face = largestFace(cut, cut.pieces.cell[p]);
    report.worstClosure = std::max(report.worstClosure, length(sums[p]) / face);
  }
}

std::size_t countNonzero(std::span<const std::uint8_t> flags) {
  return flags.size() - static_cast<std::size_t>(std::ranges::count(flags, 0));
}

template <typename Cut>
void checkRanges(const Cut& cut, CutCellsReport& report) {
  const auto& pieces = cut.pieces;
  const auto& rows = rowsOf(cut);
  for (std::size_t row = 0; row < cutCount(cut); ++row) {
    const auto box = boxOfRow(cut, row);
    const auto size = box.size();
    double fluid = 0;
    for (auto p = rows.firstPiece[row]; p < rows.firstPiece[row + 1]; ++p) {
      const bool isRight = pieces.volume[p] >= 0 && isIn(box, pieces.centroid[p]) &&
                           isIn(box, pieces.wallCentroid[p]);
      if (!isRight) ++report.outOfRange;
      fluid += pieces.volume[p];
    }
    if (!(fluid <= size.x * size.y * size.z * (1 + kSlack))) ++report.outOfRange;
    if (rows.isThin(row)) ++report.thinCells;
    if (isOnlyTouched(cut, row)) ++report.touchedCells;
    if (rows.firstPiece[row + 1] > rows.firstPiece[row] + 1) ++report.multiPieceCells;
  }
  const auto& arcs = cut.arcs;
  for (std::size_t a = 0; a < arcs.area.size(); ++a) {
    if (!(arcs.area[a] >= 0 && arcs.area[a] <= faceAreaOf(cut, a) * (1 + kSlack))) {
      ++report.outOfRange;
    }
  }
}

/// The volumes of the cells that are cut and of their fluid, and their walls.
struct CutSums {
  DoubleDouble volume;
  DoubleDouble fluid;
  DoubleDouble wall;
};
template <typename Cut>
CutSums sumsOf(const Cut& cut) {
  CutSums sums;
  for (std::size_t row = 0; row < cutCount(cut); ++row) {
    const auto size = boxOfRow(cut, row).size();
    sums.volume += size.x * size.y * size.z;
  }
  for (std::size_t p = 0; p < pieceCount(cut); ++p) {
    sums.fluid += cut.pieces.volume[p];
    sums.wall += cut.pieces.wallArea[p];
  }
  return sums;
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

/// What holds for rows alone.
template <typename Cut>
CutCellsReport checkedRows(const Cut& cut) {
  CutCellsReport report{.cutCells = cutCount(cut)};
  report.worstMoments = worstMoments(cut);
  checkClosure(cut, report);
  checkRanges(cut, report);
  const auto& rows = rowsOf(cut);
  report.meetingCells = countNonzero(std::span(rows.meets).first(cutCount(cut)));
  report.planeCells = countNonzero(std::span(rows.wallFaces).first(cutCount(cut)));
  return report;
}

}  // namespace

CutCellsReport check(const CutLeaves& leaves) {
  auto report = checkedRows(leaves);
  const auto sums = sumsOf(leaves);
  report.fluidVolume = static_cast<double>(sums.fluid + DoubleDouble(leaves.wholeFluid));
  report.bodyVolume = static_cast<double>(sums.volume - sums.fluid) + leaves.wholeBody;
  report.wallArea = static_cast<double>(sums.wall);
  return report;
}

CutCellsReport check(const CutCells& cells) {
  auto report = checkedRows(cells);
  const auto sums = sumsOf(cells);
  const auto& planes = cells.grid.planes;
  double all = 1;
  for (const auto& axis : planes) all *= axis[axis.size() - 2] - axis[1];
  report.bodyVolume = wholeBodyVolume(cells) + static_cast<double>(sums.volume - sums.fluid);
  report.fluidVolume = all - report.bodyVolume;
  report.wallArea = static_cast<double>(sums.wall);
  return report;
}

}  // namespace cutwater
