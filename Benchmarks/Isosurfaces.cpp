// Isosurfaces on grids, beside a plain loop over all nodes that only evaluates the solid: prints a
// table as Markdown. Needs no peer.
//
//   cutwater_isosurface_benchmark [surface]

#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cstdio>
#include <exception>

#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

/// Of one value at every node, one after the other.
double loopSeconds(const Solid<double>& solid, const GridPatch<double>& nodes) {
  const auto& [lo, hi] = nodes.indices;
  double sum = 0;
  const double seconds = bestSecondsOf([&] {
    for (auto k = lo.k; k <= hi.k; ++k) {
      for (auto j = lo.j; j <= hi.j; ++j) {
        for (auto i = lo.i; i <= hi.i; ++i) {
          sum += solid.signedDistance(nodes.level.position({i, j, k}));
        }
      }
    }
  });
  if (sum == 0.125) std::printf("\n");  // keeps the sum
  return seconds;
}

void printRow(const char* name, const Solid<double>& solid, int cells) {
  const auto box = solid.boundingBox();
  const auto nodes = nodesAround(box, maxComponent(box.size()) / cells);
  const auto count = static_cast<double>(nodes.indices.count());
  std::size_t triangles = 0;
  const auto seconds = [&](int threads) {
    return bestSecondsOf(
        [&] { triangles = isosurface<double>(solid, nodes, {.threads = threads}).polygonCount(); });
  };
  const double one = seconds(1);
  const double two = seconds(2);
  const double loop = loopSeconds(solid, nodes);
  std::printf("| %s | %.2f | %zu | %.3f | %.3f | %.3f | %.1f | %.1f |\n", name, 1e-6 * count,
              triangles, loop, one, two, 1e-6 * count / one, loop / one);
  std::fflush(stdout);
}

void run(const char* file) {
  std::printf(
      "| solid | million nodes | triangles | loop, s | isosurface, s | 2 threads | million nodes/s "
      "| loop / isosurface |\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
  const Sphere<double> ball({0, 0, 0}, 1);
  const PeriodicLattice<double> octet(UnitCell::octet(), {.period = {1, 1, 1}, .count = {4, 4, 4}},
                                      0.08);
  const MeshSDF<double> capsule(file != nullptr ? readSurface(file).soup
                                                : tessellation::capsule(0.4, 3, 256, 96));
  for (const int cells : {100, 200, 400}) {
    printRow("ball", ball, cells);
    printRow("ring and ball", Torus<double>(1, 0.3) | ball, cells);
    printRow("4^3 octet cells", octet, cells);
    printRow("mesh", capsule, cells);
  }
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int argc, char** argv) try {
  cutwater::benchmarks::run(argc > 1 ? argv[1] : nullptr);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_isosurface_benchmark: %s\n", error.what());
  return 1;
}
