// AMR meshes around a surface: cells per second by level and threads, and what hints of boxes save.
// Prints tables as Markdown. Needs no peer; Benchmarks/snappy sets snappyHexMesh beside it.
//
//   cutwater_mesh_benchmark hull.stl.gz [finest level, 6 to 11]

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>

#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

/// A surface that counts the boxes it is asked about, and may keep their hints from it.
class Counted final : public SignedDistanceFunction<double> {
 public:
  Counted(const MeshSDF<double>& surface, bool passesHints)
      : surface_(surface), passesHints_(passesHints) {}

  [[nodiscard]] long classes() const { return classes_; }
  [[nodiscard]] long bounds() const { return bounds_; }

 private:
  double localSignedDistance(const Vec3<double>& p) const override {
    return surface_.signedDistance(p);
  }
  BoxClass localClassify(const OrientedBox<double>& box, BoxHint* hint) const override {
    ++classes_;
    return classOf(surface_, box, passesHints_ ? hint : nullptr);
  }
  Interval<double> localBounds(const OrientedBox<double>& box, BoxHint* hint) const override {
    ++bounds_;
    return boundsOf(surface_, box, passesHints_ ? hint : nullptr);
  }
  Guarantee<double> localGuarantee() const override { return surface_.guarantee(); }
  Box<double> localBoundingBox() const override { return surface_.boundingBox(); }

  const MeshSDF<double>& surface_;
  bool passesHints_;
  mutable std::atomic<long> classes_ = 0;
  mutable std::atomic<long> bounds_ = 0;
};

/// One cube around the surface, 1.25 times as wide as that is long.
OctreeDomain<double> cubeAround(const Box<double>& surface) {
  const double width = 1.25 * maxComponent(surface.size());
  const double half = width / 2;
  return {surface.center() - Vec3<double>{half, half, half}, width, {1, 1, 1}};
}

struct Times {
  std::size_t cells = 0;
  double mesh = Box<double>::kInf;    ///< seconds
  double values = Box<double>::kInf;  ///< of distance, normal and patch in every cell
};

/// The best of some rounds.
Times timesOf(const MeshSDF<double>& surface, int level, int threads, int rounds) {
  const auto domain = cubeAround(surface.boundingBox());
  Times best;
  for (int round = 0; round < rounds; ++round) {
    std::optional<Octree<double>> mesh;
    best.mesh = std::min(best.mesh, secondsOf([&] {
                           mesh.emplace(surface, domain, Refinement<double>{.cut = level},
                                        OctreeOptions{.threads = threads});
                         }));
    const auto count = mesh->cells().size();
    std::vector<double> distance(count);
    std::vector<Vec3<double>> normal(count);
    std::vector<std::uint32_t> patch(count);
    best.values = std::min(best.values, secondsOf([&] {
                             fill(surface, *mesh, {distance, normal, patch}, {.threads = threads});
                           }));
    best.cells = count;
  }
  return best;
}

void printLevels(const MeshSDF<double>& surface, int deepest) {
  std::printf(
      "| level | cells | threads | mesh, s | values, s | cells/s, mesh | mesh and values |\n"
      "|---:|---:|---:|---:|---:|---:|---:|\n");
  for (int level = 6; level <= deepest; ++level) {
    for (const int threads : {1, 2}) {
      const auto t = timesOf(surface, level, threads, level < 11 ? 5 : 2);
      const auto cells = static_cast<double>(t.cells);
      std::printf("| %d | %zu | %d | %.3f | %.3f | %.2f M | %.2f M |\n", level, t.cells, threads,
                  t.mesh, t.values, 1e-6 * cells / t.mesh, 1e-6 * cells / (t.mesh + t.values));
      std::fflush(stdout);
    }
  }
}

/// Seconds for a mesh with a band about the surface, one thread; the best of five.
void printHints(const MeshSDF<double>& surface, int level, bool passesHints) {
  const auto domain = cubeAround(surface.boundingBox());
  const double band = 4 * domain.level(level).spacing().x;
  const Refinement<double> refinement{.cut = level, .bands = {{band, level - 1}}};
  double best = Box<double>::kInf;
  for (int round = 0; round < 5; ++round) {
    const Counted counted(surface, passesHints);
    std::optional<Octree<double>> mesh;
    best = std::min(best, secondsOf([&] {
                      mesh.emplace(counted, domain, refinement, OctreeOptions{.threads = 1});
                    }));
    if (round > 0) continue;
    const auto cells = static_cast<double>(mesh->cells().size());
    std::printf("| %d | %s | %zu | %.2f | %.2f |", level, passesHints ? "yes" : "no",
                mesh->cells().size(), static_cast<double>(counted.classes()) / cells,
                static_cast<double>(counted.bounds()) / cells);
  }
  std::printf(" %.3f |\n", best);
}

void run(const char* file, int deepest) {
  const MeshSDF<double> surface(readSurface(file).soup);
  printLevels(surface, deepest);
  std::printf(
      "\n| level | hints | cells | classifications per cell | bounds per cell | seconds, one "
      "thread |\n"
      "|---:|---|---:|---:|---:|---:|\n");
  for (const int level : {6, 8, 10}) {
    printHints(surface, level, false);
    printHints(surface, level, true);
  }
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int count, char** arguments) try {
  if (count < 2) throw std::invalid_argument("name a surface");
  cutwater::benchmarks::run(arguments[1],
                            count > 2 ? std::clamp(std::atoi(arguments[2]), 6, 11) : 10);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cutwater_mesh_benchmark: %s\n", error.what());
  return 1;
}
