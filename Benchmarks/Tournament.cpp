#include "Tournament.hpp"

#include "Meshes.hpp"
#include "PeakMemory.hpp"

namespace cutwater::benchmarks {

namespace {

/// Takes too long to be repeated as often as the rest.
bool isLong(const Race& race) {
  const bool isFill = race.workload == "grid" || race.workload == "band";
  const bool fillsAll = isFill && (race.contestant == kOurs || race.contestant == "OpenVDB");
  return fillsAll || race.workload == "build" || race.workload == "read";
}

void addCounters(const Effort& effort, benchmark::UserCounters& counters) {
  counters["nodes"] = effort.perQuery(effort.opened.nodes);
  counters["necessary_nodes"] = effort.perQuery(effort.necessary.nodes);
  counters["leaves"] = effort.perQuery(effort.opened.leaves);
  counters["necessary_leaves"] = effort.perQuery(effort.necessary.leaves);
  counters["evaluated"] = effort.perQuery(effort.evaluated);
}

}  // namespace

Tournament::Tournament(const Settings& settings, Report& report)
    : settings_(settings), report_(report), kinds_(workloads()) {}

void Tournament::enlist() {
  for (const auto& surface : surfaceNames(settings_.triangles)) {
    for (const int threads : std::set<int>{1, availableThreads()}) {
      for (const auto& kind : kinds_) {
        for (int round = 0; round < settings_.rounds; ++round) {
          for (const auto& contestant : kind.contestants) {
            const Race race{surface, threads, kind.name, contestant};
            if (isLong(race) && round >= settings_.longRounds) continue;
            const auto name = surface + "/" + kind.name + "/threads:" + std::to_string(threads) +
                              "/" + contestant + "/round:" + std::to_string(round);
            const auto runIt = [this, race, &kind](benchmark::State& s) { run(s, race, kind); };
            benchmark::RegisterBenchmark(name.c_str(), runIt)->Iterations(1)->UseManualTime();
          }
        }
      }
    }
  }
}

void Tournament::run(benchmark::State& state, const Race& race, const WorkloadKind& kind) {
  auto& its = workload(race, kind);
  Workload::Round round;
  for ([[maybe_unused]] auto step : state) {
    round = its.run(race.contestant, race.threads);
    state.SetIterationTime(round.seconds);
  }
  const double nanoseconds = round.seconds / round.queries * 1e9;
  state.counters["ns_per_query"] = nanoseconds;
  report_.add(race, {nanoseconds, round.share, round.queries / round.share});
  if (checked_.emplace(race.surface, race.workload, race.contestant).second) {
    its.check(race.contestant);
  }
  if (const auto* effort = report_.findEffort(race)) addCounters(*effort, state.counters);
  if (race.workload == "build") measureMemory(race.contestant);
}

Workload& Tournament::workload(const Race& race, const WorkloadKind& kind) {
  if (!arena_ || arena_->name() != race.surface) {
    workloads_.clear();
    arena_.reset();
    arena_ = std::make_unique<Arena>(race.surface, settings_, report_);
  }
  auto& made = workloads_[kind.name];
  if (!made) made = kind.make(*arena_);
  return *made;
}

void Tournament::measureMemory(const std::string& contestant) {
  auto& memory = report_.memory[{arena_->name(), contestant}];
  if (memory.peak == 0) memory = memoryInChild(arena_->name(), contestant, settings_);
}

}  // namespace cutwater::benchmarks
