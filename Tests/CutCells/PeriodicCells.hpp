#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>

#include <array>
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
inline void expectRepeats(const CellCutter& cutter, int n, double lower,
                          const CutOptions& options = {}) {
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

}  // namespace cutwater::test
