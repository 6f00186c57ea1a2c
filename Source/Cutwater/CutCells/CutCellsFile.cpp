#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFile.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFlaws.hpp>

// A file of cut cells, see RowFile.hpp.

namespace cutwater {

namespace {

constexpr RowFileKind kCellsFile{
    .magic = {'\x89', 'C', 'u', 't', 'C', 'e', 'l', '\x1a'}, .version = 5, .rows = "cells"};

/// Visits all that is in cut cells. What is added to them and not named here does not compile.
template <typename Cells, typename Visit>
void visitCells(Cells& all, Visit&& visit) {
  auto& [grid, cells, pieces, arcs, openArcs, wallParts, patchNames, cellCount, pieceCount, moments,
         quadrature, arcPolygons, wallPolygons, firstWallPolygon, bodyRuns] = all;
  auto& [planes, first, period] = grid;
  for (auto& across : planes) visit(across);
  visit(first.i);
  visit(first.j);
  visit(first.k);
  for (auto& along : period) visit(along);
  const auto visitEach = [&](auto&... arrays) { (visit(arrays), ...); };
  auto& [index, firstPiece, fluidCorners, meets, wallFaces, error] = cells;
  visitEach(index, firstPiece, fluidCorners, meets, wallFaces, error);
  visitPieces(pieces, visit);
  auto& [below, above, area, centroid, cell, axis] = arcs;
  visitEach(below, above, area, centroid, cell, axis);
  visitOpenArcs(openArcs, visit);
  visitWallParts(wallParts, visit);
  visitEach(patchNames, cellCount, pieceCount);
  visitOnRequest(all, visit);
  visit(bodyRuns);
}

}  // namespace

std::vector<std::byte> toBytes(const CutCells& cells) {
  if (const auto* const flaw = flawOf(cells)) {
    throw Error(ErrorKind::Argument,
                std::string("toBytes: need cut cells as they are made: ") + flaw);
  }
  RowWriter writer;
  visitCells(cells, writer);
  return std::move(writer).finish(kCellsFile);
}

CutCells cutCellsFrom(std::span<const std::byte> bytes) {
  CutCells cells;
  RowReader reader(bytes, kCellsFile);
  visitCells(cells, reader);
  reader.finish(flawOf(cells));
  return cells;
}

void saveCutCells(const std::filesystem::path& path, const CutCells& cells) {
  saveRows(path, toBytes(cells));
}

CutCells loadCutCells(const std::filesystem::path& path) {
  return loadRows(path, cutCellsFrom);
}

}  // namespace cutwater
