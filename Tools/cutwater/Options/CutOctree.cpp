#include "Options/CutOctree.hpp"

#include <algorithm>
#include <cmath>

#include "Options/CuttingCost.hpp"
#include "Options/LoadSurface.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

/// The leaves that the surface cuts.
double expectedLeaves(int level, const PlacedSurface& placed, const OctreeDomain<double>& domain,
                      const OctreeEstimate& mesh) {
  const auto sizeOf = [&](int l) {
    return std::ldexp(domain.spacing(), -l) * Vec3<double>{1, 1, 1};
  };
  // A leaf that is divided further makes four of it, along a sheet.
  double cut = placed.expectedCells(sizeOf(level));
  for (int finer = level; finer < mesh.deepest(); ++finer) cut += 3 * mesh.divided(finer);
  return std::min({cut, placed.expectedCells(sizeOf(mesh.deepest())), mesh.cells()});
}

}  // namespace

Octree<double> octreeToCut(const CutOctree& wanted, const Solid<double>& solid, const Cutter& trial,
                           const PlacedSurface& placed) {
  constexpr double kBytesOfLeaf = 30;  // as measured
  const auto domain = domainAround(boxAround(solid), wanted.mesh);
  const auto rules = rulesFor(wanted.mesh.refinement, solid.patchNames());
  OctreeOptions how{.balance = wanted.mesh.balance, .threads = wanted.threads};
  const auto estimated = estimate(solid, domain, rules, how);
  const double leaves = expectedLeaves(rules.cut, placed, domain, estimated);
  const double bytes = OctreeEstimate::kBytesPerCell + kBytesOfLeaf + wanted.bytesPerLeaf +
                       bytesToCut(leaves, placed.triangles, wanted.polygons) / estimated.cells();
  const double seconds = secondsToCut(leaves, [&](int halvings) {
    const Octree<double> coarser(solid, domain, {.cut = std::max(0, rules.cut - halvings)}, how);
    Stopwatch watch;
    const auto found = trial.cut(coarser, {.polygons = wanted.polygons, .threads = wanted.threads});
    return CutCount{static_cast<double>(found.cut.leaf.size()), watch.lap()};
  });
  requireRoom(wanted.mesh, estimated, bytes, std::max(0.0, seconds) / estimated.cells(),
              !wanted.quiet);
  how.maxCells = static_cast<std::size_t>(mostCells(wanted.mesh, bytes));
  ProgressBar bar("meshing", !wanted.quiet);
  how.progress = bar.callback();
  return Octree<double>(solid, domain, rules, how);
}

}  // namespace cutwater::tool
