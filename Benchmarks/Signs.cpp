// Signs of surfaces that are open or meet themselves: what they cost more than those of simple
// ones, and that they are those of the winding number, to the bit. Prints a table as Markdown.
//
//   cutwater_sign_benchmark bull.off wigley.stl.gz ...

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "Points.hpp"
#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

constexpr std::size_t kPoints = 100'000;

struct Contestant {
  MeshSDF<double> mesh;
  std::vector<double> values = std::vector<double>(kPoints);
  double seconds = std::numeric_limits<double>::infinity();
};

void run(const std::filesystem::path& path) {
  auto soup = readSurface(path).soup;
  weldExactly(soup);
  const auto made = [&](const MeshSDFOptions& options) {
    return Contestant{MeshSDF<double>(soup, options)};
  };
  // By the nearest faces, by default, and by the winding number of all triangles.
  std::vector<Contestant> all;
  all.push_back(made({.signs = SignScheme::NearestFeature, .findSelfIntersections = false}));
  all.push_back(made({}));
  all.push_back(made({.signs = SignScheme::WindingNumber, .findSelfIntersections = false}));
  const auto points = narrowPoints(triangulated(soup), kPoints);
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    for (auto& [mesh, values, seconds] : all) {
      const double took = secondsOf([&, &solid = mesh, &out = values] {
        for (std::size_t i = 0; i < kPoints; ++i) out[i] = solid.signedDistance(points[i]);
      });
      seconds = std::min(seconds, took);
    }
  }
  const auto& signs = all[1].mesh.signReport();
  const auto nanoseconds = [&](std::size_t i) { return 1e9 * all[i].seconds / kPoints; };
  std::printf("| %s | %zu | %zu | %zu | %.0f | %.0f (%.2f) | %.0f (%.2f) | %s |\n",
              path.filename().c_str(), all[1].mesh.triangleCount(), signs.unbalancedEdges,
              signs.selfIntersections.value_or(0), nanoseconds(0), nanoseconds(1),
              all[1].seconds / all[0].seconds, nanoseconds(2), all[2].seconds / all[0].seconds,
              all[1].values == all[2].values ? "yes" : "no");
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int argc, char** argv) {
  try {
    std::printf(
        "| surface | triangles | open edges | pairs that meet | by the nearest, ns | by default | "
        "by all triangles | same values |\n|---|---:|---:|---:|---:|---:|---:|---|\n");
    for (int i = 1; i < argc; ++i) cutwater::benchmarks::run(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
