#pragma once

#include "Arena.hpp"
#include "Seconds.hpp"

namespace cutwater::benchmarks {

/// A question put to all contestants.
class Workload {
 public:
  virtual ~Workload() = default;
  explicit Workload(Arena& arena) : arena_(arena) {}
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;

  struct Round {
    double seconds = 0;
    double queries = 0;
    double share = 1;  ///< of the workload's points
  };
  virtual Round run(const std::string& contestant, int threads) = 0;
  /// Of a contestant's answers, once. The first peer's answers check all of ours, too.
  virtual void check(const std::string& /*contestant*/) {}

 protected:
  Arena& arena_;
};

struct WorkloadKind {
  std::string name;
  std::vector<std::string> contestants;
  std::unique_ptr<Workload> (*make)(Arena& arena);
};

/// All of them, in the order of the table.
[[nodiscard]] std::vector<WorkloadKind> workloads();

// Points, one by one, the same repeatedly, and as a batch.
std::unique_ptr<Workload> makeUniform(Arena& arena);
std::unique_ptr<Workload> makeNarrow(Arena& arena);
std::unique_ptr<Workload> makeUniformHot(Arena& arena);
std::unique_ptr<Workload> makeNarrowHot(Arena& arena);
std::unique_ptr<Workload> makeUniformBatch(Arena& arena);
std::unique_ptr<Workload> makeNarrowBatch(Arena& arena);
// Grids.
std::unique_ptr<Workload> makeGrid(Arena& arena);
std::unique_ptr<Workload> makeBand(Arena& arena);
// Once per surface; queries are triangles.
std::unique_ptr<Workload> makeBuild(Arena& arena);
std::unique_ptr<Workload> makeRead(Arena& arena);

/// How many of the available queries take about so many seconds, by asking a few.
[[nodiscard]] std::size_t affordable(FunctionRef<void(std::size_t count)> ask,
                                     std::size_t available, double seconds);

}  // namespace cutwater::benchmarks
