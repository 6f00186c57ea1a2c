#include "Workload.hpp"

#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <omp.h>

#include "Meshes.hpp"

namespace cutwater::benchmarks {

namespace {

class Build final : public Workload {
 public:
  using Workload::Workload;

  Round run(const std::string& contestant, int threads) override {
    Round round{.queries = static_cast<double>(arena_.soup().polygonCount())};
    if (contestant == kOurs) {
      const int most = availableThreads();
      omp_set_num_threads(threads);
      std::optional<MeshSDF<double>> built;
      round.seconds = secondsOf([&] { built.emplace(arena_.soup()); });
      omp_set_num_threads(most);
    }
    for (const auto& kind : peers()) {
      if (kind.name != contestant) continue;
      std::unique_ptr<Peer> built;
      round.seconds = secondsOf([&] { built = kind.build(arena_.soup(), threads); });
    }
    return round;
  }
};

class Read final : public Workload {
 public:
  using Workload::Workload;

  Round run(const std::string&, int) override {
    const auto file = surfaceFile(arena_.name(), arena_.settings().data);
    std::optional<SurfaceFile> read;
    const double seconds = secondsOf([&] { read = readSurface(file); });
    return {.seconds = seconds, .queries = static_cast<double>(read->soup.polygonCount())};
  }
};

std::vector<std::string> oursAnd(bool bands) {
  std::vector<std::string> names{kOurs};
  for (const auto& kind : peers()) names.push_back(kind.name);
  if (bands) {
    for (const auto& kind : peerBands()) names.push_back(kind.name);
  }
  return names;
}

}  // namespace

std::size_t affordable(FunctionRef<void(std::size_t)> ask, std::size_t available, double seconds) {
  const auto trial = std::min<std::size_t>(available, 500);
  ask(1);  // builds what is not built yet
  const double took = secondsOf([&] { ask(trial); });
  const double fits = seconds / took * static_cast<double>(trial);
  return static_cast<std::size_t>(
      std::clamp(fits, static_cast<double>(trial), static_cast<double>(available)));
}

std::unique_ptr<Workload> makeBuild(Arena& arena) {
  return std::make_unique<Build>(arena);
}
std::unique_ptr<Workload> makeRead(Arena& arena) {
  return std::make_unique<Read>(arena);
}

std::vector<WorkloadKind> workloads() {
  const auto all = oursAnd(false);
  return {{"uniform", all, makeUniform},
          {"uniform-hot", all, makeUniformHot},
          {"uniform-batch", {kOurs}, makeUniformBatch},
          {"narrow", all, makeNarrow},
          {"narrow-hot", all, makeNarrowHot},
          {"narrow-batch", {kOurs}, makeNarrowBatch},
          {"grid", all, makeGrid},
          {"band", oursAnd(true), makeBand},
          {"build", all, makeBuild},
          {"read", {kOurs}, makeRead}};
}

}  // namespace cutwater::benchmarks
