#pragma once

#include <benchmark/benchmark.h>
#include <set>
#include <tuple>

#include "Workload.hpp"

namespace cutwater::benchmarks {

/// All surfaces, numbers of threads, workloads and rounds as benchmarks of Google Benchmark, so
/// that its options choose among them. Within a round contestants take turns: what else goes on on
/// the machine hits all alike. Structures are built when the first benchmark needs them and are
/// freed with the last of their surface.
class Tournament {
 public:
  Tournament(const Settings& settings, Report& report);

  /// Names are surface/workload/threads:n/contestant/round:i.
  void enlist();

 private:
  void enlist(const Race& race, const WorkloadKind& kind);
  void run(benchmark::State& state, const Race& race, const WorkloadKind& kind);
  Workload& workload(const Race& race, const WorkloadKind& kind);
  void measureMemory(const std::string& contestant);

  const Settings& settings_;
  Report& report_;
  std::vector<WorkloadKind> kinds_;
  std::unique_ptr<Arena> arena_;
  std::map<std::string, std::unique_ptr<Workload>> workloads_;
  std::set<std::tuple<std::string, std::string, std::string>> checked_;
};

}  // namespace cutwater::benchmarks
