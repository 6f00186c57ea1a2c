// Lattices of struts, without memory and as explicit beams: prints tables as Markdown. Needs no
// peer.
//
//   cutwater_lattice_benchmark

#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/Detail/SearchedCells.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "Seconds.hpp"
#include "Support/Random.hpp"

namespace cutwater::benchmarks {

namespace {

using Points = std::vector<Vec3<double>>;

/// In [0, extent]^3.
Points pointsIn(double extent, int count) {
  test::RandomPoints<double> random(0.5 * extent, 7);
  const Vec3<double> center{0.5 * extent, 0.5 * extent, 0.5 * extent};
  Points points(static_cast<std::size_t>(count));
  for (auto& p : points) p = center + random.next();
  return points;
}

/// Of the best of three rounds.
template <typename Ask>
double nanosecondsPerPoint(const Points& points, const Ask& ask) {
  return 1e9 * bestSecondsOf([&] { ask(points); }) / static_cast<double>(points.size());
}

/// Keeps a value from being optimised away.
double checksum = 0;

template <typename Value>
double nanosecondsOneByOne(const Points& points, const Value& value) {
  return nanosecondsPerPoint(points, [&](const Points& all) {
    for (const auto& p : all) checksum += value(p);
  });
}

double nanosecondsInBatch(const SignedDistanceFunction<double>& solid, const Points& points) {
  std::vector<double> values(points.size());
  return nanosecondsPerPoint(
      points, [&](const Points& all) { solid.signedDistances(all, values, {.threads = 1}); });
}

void printCells() {
  std::printf(
      "| cell | evaluator | ns per value | in a batch | closest point | by search | array of 10^3 "
      "| "
      "the same, explicit |\n|---|---|---:|---:|---:|---:|---:|---:|\n");
  constexpr double kRadius = 0.08;
  const auto points = pointsIn(10, 50'000);
  for (const auto& cell : UnitCell::all()) {
    const PeriodicLattice<double> endless(cell, {1, 1, 1}, kRadius);
    const PeriodicLattice<double> array(cell, {{1, 1, 1}, {10, 10, 10}}, kRadius);
    const BeamLattice<double> beams(beamsOf(cell, array.cells(), kRadius));
    const detail::SearchedCells<double> search(cell, {.period = {1, 1, 1}});
    const auto value = [](const auto& solid) {
      return [&](const Vec3<double>& p) { return solid.signedDistance(p); };
    };
    const bool isFolded = cell.foldAt({1, 1, 1}) != CellFold::None;
    std::printf(
        "| %s | %s | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", cell.name().c_str(),
        isFolded ? "folding" : "search", nanosecondsOneByOne(points, value(endless)),
        nanosecondsInBatch(endless, points),
        nanosecondsOneByOne(points,
                            [&](const auto& p) { return endless.closestPoint(p).distance; }),
        nanosecondsOneByOne(points, [&](const auto& p) { return search.nearest(p).distance; }),
        nanosecondsOneByOne(points, value(array)), nanosecondsOneByOne(points, value(beams)));
    std::fflush(stdout);
  }
}

/// Beams of the graph in a tree of general primitives.
LinearBVH<double, ConeSphereBeam<double>> generalTree(const BeamGraph& graph) {
  std::vector<ConeSphereBeam<double>> beams;
  for (const auto& [nodes, radii, body, caps] : graph.beams) {
    beams.emplace_back(graph.nodes[nodes[0]], graph.nodes[nodes[1]], radii[0], radii[1]);
  }
  return LinearBVH<double, ConeSphereBeam<double>>(std::move(beams));
}

/// A block of points 1/500 apart, row by row.
Points gridPoints() {
  constexpr int kSide = 40;
  Points points;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const auto at = [](int index) { return 0.4 + (index % kSide + 0.3) / 500; };
    points.push_back({at(i), at(i / kSide), at(i / kSide / kSide)});
  }
  return points;
}

/// @throws std::logic_error if a value is not that of the plain loop.
void printBeams(const char* name, std::uint32_t cells, double tapering) {
  const double size = 1.0 / cells;
  auto graph = beamsOf(UnitCell::octet(), {{size, size, size}, {cells, cells, cells}}, 0.08 * size);
  for (std::size_t i = 0; i < graph.beams.size(); ++i) {
    graph.beams[i].radii[1] *= 1 - tapering * static_cast<double>(i % 1000) / 1000;
  }
  std::optional<BeamLattice<double>> lattice;
  const double building = secondsOf([&] { lattice.emplace(graph); });
  const auto tree = generalTree(graph);
  const auto points = pointsIn(1, 100'000);
  const Points few(points.begin(), points.begin() + 20);
  std::vector<double> values;
  const double loop = nanosecondsOneByOne(few, [&](const Vec3<double>& p) {
    double least = Box<double>::kInf;
    for (const auto& beam : tree.primitives()) least = std::min(least, beam.distance(p));
    if (least != lattice->signedDistance(p)) throw std::logic_error("not the plain loop's value");
    return least;
  });
  std::printf(
      "| %s | %zu | %.2f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", name, graph.beams.size(),
      building, loop,
      nanosecondsOneByOne(points, [&](const auto& p) { return tree.nearest(p).distance; }),
      nanosecondsOneByOne(points, [&](const auto& p) { return lattice->signedDistance(p); }),
      nanosecondsInBatch(*lattice, gridPoints()), nanosecondsOneByOne(points, [&](const auto& p) {
        return lattice->closestPoint(p).distance;
      }));
  std::fflush(stdout);
}

void run() {
  printCells();
  std::printf(
      "\n| octet array | beams | built in s | plain loop, ns | general tree | packets of 16 | "
      "batch "
      "on a grid | closest point |\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t cells : {3U, 7U, 16U, 34U}) printBeams("one radius", cells, 0);
  for (const std::uint32_t cells : {3U, 7U, 16U, 34U}) printBeams("tapered", cells, 0.5);
}

}  // namespace

}  // namespace cutwater::benchmarks

int main() try {
  cutwater::benchmarks::run();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_lattice_benchmark: %s\n", error.what());
  return 1;
}
