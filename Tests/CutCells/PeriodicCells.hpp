#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "Support/CutIdentities.hpp"
#include "Support/CutPolygons.hpp"

namespace cutwater::test {

inline std::vector<double> planesOfPeriod(int cells, double lower, double width) {
  std::vector<double> result;
  for (int n = 0; n <= cells; ++n) result.push_back(lower + n * (width / cells));
  return result;
}

/// The pieces of a cell, and what is open in its faces, but for where it is.
struct RepeatedCell {
  std::vector<double> numbers;
  std::vector<Vec3<double>> points;
};
inline RepeatedCell repeatedCell(const CutCells& cells, const Index3& cell) {
  RepeatedCell result;
  result.numbers.push_back(static_cast<double>(cells.classOf(cell)));
  const auto row = cells.rowOf(cell);
  if (row == CutCells::kNoRow) return result;
  const auto& rows = cells.cells;
  for (const double number :
       {double(rows.fluidCorners[row]), double(rows.meets[row]), double(rows.wallFaces[row])}) {
    result.numbers.push_back(number);
  }
  for (auto p = rows.firstPiece[row]; p < rows.firstPiece[row + 1]; ++p) {
    const auto& pieces = cells.pieces;
    const auto& v = pieces.wallVector[p];
    for (const double number : {pieces.volume[p], pieces.wallArea[p], v.x, v.y, v.z}) {
      result.numbers.push_back(number);
    }
    result.points.push_back(pieces.centroid[p]);
    result.points.push_back(pieces.wallCentroid[p]);
    if (cells.moments.degree < 0) continue;
    const auto moments = cells.moments.ofVolume(p);
    result.numbers.insert(result.numbers.end(), moments.begin(), moments.end());
  }
  const auto ordinal = [&](std::uint32_t side) {
    if (side >= cells.pieces.cell.size()) return -1.0 * (side - CutCells::kBeyond + 1);
    return double(side - rows.firstPiece[cells.pieces.cell[side]]);
  };
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (cells.arcs.cell[a] != cell && cells.arcs.cellBelow(a) != cell) continue;
    for (const double number : {double(cells.arcs.axis[a]), cells.arcs.area[a],
                                ordinal(cells.arcs.below[a]), ordinal(cells.arcs.above[a])}) {
      result.numbers.push_back(number);
    }
    result.points.push_back(cells.arcs.centroid[a]);
  }
  return result;
}

/// Compares a cell with one a number of periods below it: the same bits, but for the shift.
inline void expectSameBut(const RepeatedCell& one, const RepeatedCell& other,
                          const Vec3<double>& shift) {
  ASSERT_EQ(one.numbers, other.numbers);
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t n = 0; n < one.points.size(); ++n) {
    ASSERT_LT(length(one.points[n] - other.points[n] - shift), 1e-15 * (1 + length(one.points[n])));
  }
}

/// A box of cells, and others anywhere, of a grid of `n` cells in a period.
template <typename Cutter>
void expectRepeats(const Cutter& cutter, int n, double lower, const CutOptions& options = {}) {
  const auto period = cutter.period();
  std::array<std::vector<double>, 3> across;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    across[a] = planesOfPeriod(n, lower, period[axis] > 0 ? period[axis] : 1);
  }
  const auto whole =
      cutter.cut(cutter.cellsOfPeriod(across, {}, IndexBox::ofSize(n, n, n)), options);
  expectIdentities(whole, 1e-13);
  if (options.polygons) expectPolygonsOf(whole);
  const auto on = [&](int axis) { return period[axis] > 0 ? 1 : 0; };
  for (const auto& [x, y, z] :
       {std::array{n - 3, 1, -2}, std::array{-2 * n + 1, n - 1, 3 * n - 2}, std::array{2, -3, n}}) {
    const Index3 lo{x * on(0), y * on(1), z * on(2)};
    const Index3 hi{lo.i + n / 2, lo.j + n / 2, lo.k + n / 2};
    const auto part = cutter.cut(cutter.cellsOfPeriod(across, {}, {lo, hi}), options);
    expectIdentities(part, 1e-13);
    if (options.polygons) expectPolygonsOf(part);
    for (int i = lo.i; i <= hi.i; ++i) {
      for (int j = lo.j; j <= hi.j; ++j) {
        for (int k = lo.k; k <= hi.k; ++k) {
          const auto periods = [&](int at) { return (at - (at % n + n) % n) / n; };
          const Index3 same{i - n * periods(i), j - n * periods(j), k - n * periods(k)};
          const Vec3<double> shift{periods(i) * period.x, periods(j) * period.y,
                                   periods(k) * period.z};
          ASSERT_NO_FATAL_FAILURE(
              expectSameBut(repeatedCell(part, {i, j, k}), repeatedCell(whole, same), shift))
              << i << " " << j << " " << k;
        }
      }
    }
  }
}

/// Counts, and the volumes of pieces, in ascending order.
inline std::vector<double> volumesIn(const CutCells& cells, const Index3& cell) {
  const auto row = cells.rowOf(cell);
  if (row == CutCells::kNoRow) return {cells.classOf(cell) == FluidClass::Fluid ? 1.0 : 0.0};
  std::vector<double> result;
  for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
    result.push_back(cells.volumeFraction(p));
  }
  std::ranges::sort(result);
  return result;
}
/// What is open below a cell between two pieces, in ascending order: in coarser cells that is one
/// arc, while cutting gives one for each connected part.
inline std::vector<double> openBelow(const CutCells& cells, const Index3& cell, int axis) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> between;
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (cells.arcs.cell[a] == cell && cells.arcs.axis[a] == axis) {
      between[{cells.arcs.below[a], cells.arcs.above[a]}] += cells.aperture(a);
    }
  }
  std::vector<double> result;
  for (const auto& [pieces, aperture] : between) result.push_back(aperture);
  std::ranges::sort(result);
  return result;
}
inline void expectSameShares(const std::vector<double>& one, const std::vector<double>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t n = 0; n < one.size(); ++n) ASSERT_NEAR(one[n], other[n], 1e-12);
}
/// A cell of two grids: the same pieces, and the same open parts below it.
inline void expectSameCell(const CutCells& one, const CutCells& other, const Index3& cell) {
  ASSERT_NO_FATAL_FAILURE(expectSameShares(volumesIn(one, cell), volumesIn(other, cell)));
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_NO_FATAL_FAILURE(
        expectSameShares(openBelow(one, cell, axis), openBelow(other, cell, axis)));
  }
}

}  // namespace cutwater::test
