#include "Table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <set>
#include <tuple>

#include "Workload.hpp"

namespace cutwater::benchmarks {

namespace {

using Row = std::vector<std::string>;

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Three digits or more.
std::string number(double value) {
  return formatted(value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f", value);
}

/// Columns as wide as they need to be, numbers to the right.
void printAligned(const std::vector<Row>& rows, std::ostream& out) {
  std::vector<std::size_t> widths(rows.front().size(), 3);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  const auto cell = [&](const std::string& text, std::size_t c) {
    const std::string space(widths[c] - text.size(), ' ');
    return c == 0 ? text + space : space + text;
  };
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) out << "| " << cell(rows[r][c], c) << ' ';
    out << "|\n";
    if (r > 0) continue;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      out << (c == 0 ? "|:" : "|-") << std::string(widths[c], '-') << (c == 0 ? '-' : ':');
    }
    out << "|\n";
  }
  out << '\n';
}

bool isPerSurface(const std::string& workload) {
  return workload == "build" || workload == "read";
}

/// The workload that peers answer whose points a batch shares.
std::string pointByPoint(const std::string& workload) {
  return workload.substr(0, workload.find("-batch"));
}

std::vector<std::string> rivals() {
  std::vector<std::string> names;
  for (const auto& kind : peers()) names.push_back(kind.name);
  for (const auto& kind : peerBands()) names.push_back(kind.name);
  return names;
}

/// Times of one surface and number of threads; empty if nothing was measured.
std::vector<Row> timeRows(const Report& report, const std::string& surface, int threads) {
  Row head{"workload", kOurs};
  for (const auto& name : rivals()) head.insert(head.end(), {name, "times"});
  std::vector<Row> rows{head};
  for (const auto& kind : workloads()) {
    const auto* ours = report.find({surface, threads, kind.name, kOurs});
    const bool isMilliseconds = isPerSurface(kind.name);
    const double unit =
        isMilliseconds ? static_cast<double>(report.surfaces.at(surface).triangles) * 1e-6 : 1;
    Row row{kind.name + (isMilliseconds ? ", ms" : ""),
            ours ? number(unit * ours->nanoseconds) : ""};
    bool any = ours != nullptr;
    for (const auto& name : rivals()) {
      const auto* theirs = report.find({surface, threads, pointByPoint(kind.name), name});
      any = any || (theirs != nullptr && pointByPoint(kind.name) == kind.name);
      row.push_back(theirs ? number(unit * theirs->nanoseconds) : "");
      row.push_back(ours && theirs ? number(theirs->nanoseconds / ours->nanoseconds) : "");
    }
    if (any) rows.push_back(row);
  }
  return rows;
}

void printShares(const Report& report, const std::string& surface, int threads, std::ostream& out) {
  std::string text;
  for (const auto& [race, time] : report.times) {
    if (race.surface != surface || race.threads != threads || time.share > 0.999) continue;
    text += (text.empty() ? "" : "; ") + race.workload + " " + race.contestant + " " +
            formatted("%.3g", 100 * time.share) + " %";
  }
  if (!text.empty()) out << "Measured on a part of the points or cells: " << text << ".\n\n";
}

std::string megabytes(std::size_t bytes) {
  return number(static_cast<double>(bytes) * 1e-6);
}

void printMemory(const Report& report, std::ostream& out) {
  std::vector<Row> rows{{"surface", "contestant", "build peak, MB", "kept, MB", "bytes/triangle"}};
  for (const auto& [key, memory] : report.memory) {
    const auto& facts = report.surfaces.at(key.first);
    const auto triangles = static_cast<double>(facts.triangles);
    const bool isOurs = key.second == kOurs && facts.memoryBytes > 0;
    const auto bytes = static_cast<double>(isOurs ? facts.memoryBytes : memory.kept);
    rows.push_back({key.first, key.second, megabytes(memory.peak), megabytes(memory.kept),
                    number(bytes / triangles)});
  }
  if (rows.size() > 1) {
    out << "## Memory\n\nPeak and kept: resident memory of a process of its own, the soup left "
           "out. Bytes per triangle: "
        << kOurs << " by memoryBytes(), peers by what they keep.\n\n";
    printAligned(rows, out);
  }
}

/// Whole grids, in seconds, on one thread.
void printBands(const Report& report, std::ostream& out) {
  Row head{"surface", kOurs, "without writing"};
  const auto names = rivals();
  head.insert(head.end(), names.begin(), names.end());
  std::vector<Row> rows{head};
  for (const auto& [surface, facts] : report.surfaces) {
    const auto* ours = report.find({surface, 1, "band", kOurs});
    if (ours == nullptr) continue;
    Row row{surface, formatted("%.3f", ours->seconds()),
            formatted("%.3f", ours->seconds() - facts.writingSeconds)};
    for (const auto& name : names) {
      const auto* theirs = report.find({surface, 1, "band", name});
      row.push_back(theirs ? formatted("%.3f", theirs->seconds()) : "");
    }
    rows.push_back(row);
  }
  if (rows.size() == 1) return;
  out << "## Bands in all\n\nSeconds on one thread for a band of three cells in the whole grid. "
         "Without writing: less the time to write one value to all of its cells. Peers that answer "
         "points are given the cells of the band.\n\n";
  printAligned(rows, out);
}

void printEfforts(const Report& report, std::ostream& out) {
  if (report.efforts.empty()) return;
  std::vector<Row> rows{{"surface", "workload", "nodes", "necessary", "times", "leaves",
                         "necessary", "times", "evaluated", "ns", "bound of memory", "times"}};
  for (const auto& [key, effort] : report.efforts) {
    Row row{key.first, key.second};
    for (const auto part : {&Openings::nodes, &Openings::leaves}) {
      const double opened = effort.perQuery(effort.opened.*part);
      const double necessary = effort.perQuery(effort.necessary.*part);
      row.insert(row.end(), {number(opened), number(necessary), number(opened / necessary)});
    }
    row.push_back(number(effort.perQuery(effort.evaluated)));
    const double bound =
        effort.perQuery(effort.necessary.leaves) * report.surfaces.at(key.first).leafNanoseconds;
    const auto* time = report.find({key.first, 1, key.second, kOurs});
    row.push_back(time ? number(time->nanoseconds) : "");
    row.push_back(number(bound));
    row.push_back(time ? number(time->nanoseconds / bound) : "");
    rows.push_back(row);
  }
  out << "## What a query opens\n\nNodes and leaves of the tree that a query of " << kOurs
      << " opens, one by one; those of them whose box is not farther than the nearest triangle, so "
         "that no search can leave them out; and triangles evaluated in full. Bound of memory: the "
         "nanoseconds that this machine takes to fetch the necessary leaves from anywhere in as "
         "much memory as the structure takes, when none waits for another.\n\n";
  printAligned(rows, out);
}

/// Adds up the workloads of a surface.
std::vector<Check> summed(const std::vector<Check>& checks) {
  std::map<std::tuple<std::string, std::string, std::string>, Check> sums;
  for (const auto& c : checks) {
    auto& sum = sums[{c.surface, c.contestant, c.truth}];
    const bool isNew = sum.answers == 0;
    const auto before = isNew ? std::string() : sum.workload + ", ";
    sum = {.surface = c.surface,
           .workload = before + c.workload,
           .contestant = c.contestant,
           .truth = c.truth,
           .answers = sum.answers + c.answers,
           .wrongValues = sum.wrongValues + c.wrongValues,
           .wrongSigns = sum.wrongSigns + c.wrongSigns,
           .largestError = std::max(sum.largestError, c.largestError)};
  }
  std::vector<Check> result;
  for (const auto& [key, sum] : sums) result.push_back(sum);
  return result;
}

void printChecks(const Report& report, std::ostream& out) {
  if (report.checks.empty()) return;
  std::vector<Row> rows{{"surface", "contestant", "held against", "answers", "wrong values",
                         "wrong signs", "largest error / diagonal", "workloads"}};
  for (const auto& c : summed(report.checks)) {
    rows.push_back({c.surface, c.contestant, c.truth, std::to_string(c.answers),
                    std::to_string(c.wrongValues), std::to_string(c.wrongSigns),
                    formatted("%.1e", c.largestError), c.workload});
  }
  out << "## Answers\n\n";
  printAligned(rows, out);
  for (const auto& c : report.checks) {
    if (c.wrongValues + c.wrongSigns == 0) continue;
    out << "- " << c.surface << ", " << c.workload << ": " << c.contestant << " against " << c.truth
        << ": " << c.wrongValues << " wrong values and " << c.wrongSigns << " wrong signs of "
        << c.answers << " answers\n";
  }
  const auto wrong = report.wrongOfOurs();
  out << '\n' << kOurs << ": " << (wrong == 0 ? "nothing wrong" : "WRONG ANSWERS") << ".\n\n";
}

}  // namespace

void printTables(const Report& report, std::ostream& out) {
  std::set<std::pair<std::string, int>> measured;
  for (const auto& [race, time] : report.times) measured.emplace(race.surface, race.threads);
  for (const auto& [surface, facts] : report.surfaces) {
    out << "## " << surface << ": " << facts.triangles << " triangles\n\n";
    if (!facts.signs.empty()) out << "Signs by " << facts.signs << ".\n\n";
    for (const auto& [name, threads] : measured) {
      if (name != surface) continue;
      out << "Nanoseconds per query, " << threads << (threads == 1 ? " thread" : " threads")
          << "; times: how many times as long as " << kOurs << "\n\n";
      printAligned(timeRows(report, surface, threads), out);
      printShares(report, surface, threads, out);
    }
  }
  printBands(report, out);
  printEfforts(report, out);
  printMemory(report, out);
  printChecks(report, out);
}

}  // namespace cutwater::benchmarks
