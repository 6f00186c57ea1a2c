// Cut cells of a surface, on grids and octrees from coarse to fine: prints tables as Markdown.
// Needs no peer.
//
//   cutwater_cut_cell_benchmark [surface] [finest grid, 64 to 1024 cells along the longest side]

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

/// A cube around the surface, a twentieth wider than that is long.
GridPatch<double> cubeAround(const Box<double>& surface, int cells) {
  const double width = 1.05 * maxComponent(surface.size());
  const double half = width / 2;
  const double h = width / cells;
  return {Level<double>(surface.center() - Vec3<double>{half, half, half}, {h, h, h}),
          IndexBox::ofSize(cells, cells, cells)};
}

template <typename Value>
std::size_t bytesOf(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}

/// Of all rows but polygons and moments.
std::size_t bytesOf(const CutCells& cells) {
  const auto& [index, firstPiece, corners, meets, ofCells] = cells.cells;
  const auto& [cell, volume, centroid, wallArea, wallVector, wallCentroid, ofPieces] = cells.pieces;
  const auto& [below, above, area, arcCentroid, arcCell, axis] = cells.arcs;
  const auto& [piece, patch, partArea, vector, partCentroid] = cells.wallParts;
  return bytesOf(index) + bytesOf(firstPiece) + bytesOf(corners) + bytesOf(meets) + bytesOf(cell) +
         bytesOf(volume) + bytesOf(centroid) + bytesOf(wallArea) + bytesOf(wallVector) +
         bytesOf(wallCentroid) + bytesOf(ofCells) + bytesOf(ofPieces) + bytesOf(below) +
         bytesOf(above) + bytesOf(area) + bytesOf(arcCentroid) + bytesOf(arcCell) + bytesOf(axis) +
         bytesOf(piece) + bytesOf(patch) + bytesOf(partArea) + bytesOf(vector) +
         bytesOf(partCentroid) + bytesOf(cells.bodyRuns);
}

void printRow(const CellCutter& cutter, const Box<double>& surface, int n) {
  const auto grid = cubeAround(surface, n);
  CutCells cells;
  const auto seconds = [&](const CutOptions& options) {
    return bestSecondsOf([&] { cells = cutter.cut(grid, options); });
  };
  const double polygons = seconds({.polygons = true, .threads = 1});
  const double second = seconds({.moments = 2, .threads = 1});
  const double fourth = seconds({.moments = 4, .threads = 1});
  const double one = seconds({.threads = 1});
  const double two = seconds({.threads = 2});
  const double coarser = bestSecondsOf([&] { (void)coarsened(cells, {2, 2, 2}); });
  const double single = bestSecondsOf([&] { (void)merged(cells); });
  const auto count = static_cast<double>(cells.cellCount);
  std::printf("| %d | %zu | %zu | %.3f | %.0f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.0f |\n",
              n, cells.cellCount, cells.pieceCount, one, 1e-3 * count / one, two, polygons, second,
              fourth, coarser, single, static_cast<double>(bytesOf(cells)) / count);
  std::fflush(stdout);
}

/// Roots as in `cutwater cells`, 16 along the longest side; leaves of the finest level where they
/// are cut.
void printLeaves(const CellCutter& cutter, const MeshSDF<double>& mesh, int level) {
  const auto room = cubeAround(mesh.boundingBox(), 16);
  const OctreeDomain<double> domain(room.level.origin(), room.level.spacing().x, {16, 16, 16});
  const Octree<double> octree(mesh, domain, {.cut = level});
  CutLeaves leaves;
  const auto seconds = [&](const CutOptions& options) {
    return bestSecondsOf([&] { leaves = cutter.cut(octree, options); });
  };
  const double polygons = seconds({.polygons = true, .threads = 1});
  const double two = seconds({.threads = 2});
  const double one = seconds({.threads = 1});
  const auto count = static_cast<double>(leaves.cut.leaf.size());
  std::printf("| %d | %zu | %zu | %.3f | %.0f | %.3f | %.3f |\n", level, octree.cells().size(),
              leaves.cut.leaf.size(), one, 1e-3 * count / one, two, polygons);
  std::fflush(stdout);
}

void run(const char* file, int finest) {
  const MeshSDF<double> mesh(file != nullptr ? readSurface(file).soup
                                             : tessellation::torus(2, 0.7, 256, 128));
  std::printf("%zu triangles\n\n", mesh.triangleCount());
  std::printf(
      "| N | cut cells | pieces | s | thousand cells/s | 2 threads, s | with polygons, s | "
      "moments to degree 2, s | to degree 4, s | coarsened, s | merged, s | bytes a cell |\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  const CellCutter cutter{Solid<double>(mesh)};
  for (int n = 64; n <= finest; n *= 2) printRow(cutter, mesh.boundingBox(), n);
  std::printf(
      "\n| level | leaves | cut leaves | s | thousand leaves/s | 2 threads, s | with polygons, s "
      "|\n"
      "|---:|---:|---:|---:|---:|---:|---:|\n");
  for (int level = 2; 16 << level <= finest; ++level) printLeaves(cutter, mesh, level);
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int argc, char** argv) try {
  cutwater::benchmarks::run(argc > 1 ? argv[1] : nullptr, argc > 2 ? std::atoi(argv[2]) : 256);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_cut_cell_benchmark: %s\n", error.what());
  return 1;
}
