// Signs of surfaces that are open or meet themselves: what they cost more than those of simple
// ones, and that they are those of the winding number, to the bit. Prints a table as Markdown.
//
//   cutwater_sign_benchmark bull.off wigley.stl.gz ...

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <random>
#include <vector>

#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

constexpr std::size_t kPoints = 100'000;

/// Within 2 % of the diagonal of places that are spread evenly over the list of triangles; one in
/// eight beside a corner.
std::vector<Vec3<double>> pointsNear(const MeshSDF<double>& mesh) {
  std::mt19937_64 engine(5);
  const auto unit = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
  const double reach = 0.02 * mesh.surfaceBox().diagonal();
  std::vector<Vec3<double>> points;
  while (points.size() < kPoints) {
    const auto [a, b, c] =
        mesh.triangle(static_cast<std::uint32_t>(engine() % mesh.triangleCount()));
    double s = points.size() % 8 == 0 ? 0 : unit();
    double t = points.size() % 8 == 0 ? 0 : unit();
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Vec3<double> way{2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1};
    points.push_back(a + s * (b - a) + t * (c - a) + reach * unit() * way);
  }
  return points;
}

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
  const auto points = pointsNear(all[1].mesh);
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
