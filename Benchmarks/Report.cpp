#include "Report.hpp"

#include <algorithm>

namespace cutwater::benchmarks {

void Report::add(const Race& race, const Time& time) {
  const double before = times[race].nanoseconds;
  times[race] = time;
  times[race].nanoseconds = std::min(before, time.nanoseconds);
}

const Time* Report::find(const Race& race) const {
  const auto at = times.find(race);
  return at == times.end() ? nullptr : &at->second;
}

const Effort* Report::findEffort(const Race& race) const {
  const auto at = efforts.find({race.surface, race.workload});
  return at == efforts.end() || race.contestant != kOurs ? nullptr : &at->second;
}

std::size_t Report::wrongOfOurs() const {
  std::size_t count = 0;
  for (const auto& check : checks) {
    if (check.contestant == kOurs) count += check.wrongValues + check.wrongSigns;
  }
  return count;
}

}  // namespace cutwater::benchmarks
