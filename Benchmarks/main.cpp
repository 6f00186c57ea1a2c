// Cutwater's queries beside those of its peers, in one run on the same points. Scripts/bench builds
// and runs it; see Docs/performance.md for what the workloads are.

#include <exception>
#include <iostream>
#include <string_view>

#include "Meshes.hpp"
#include "PeakMemory.hpp"
#include "SpinTest.hpp"
#include "Table.hpp"
#include "Tournament.hpp"

namespace cutwater::benchmarks {

namespace {

/// One line per benchmark on stderr, so that the tables stand alone on stdout.
class ProgressReporter final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const auto& run : runs) {
      std::cerr << run.run_name.function_name << "  " << run.counters.at("ns_per_query").value
                << " ns\n";
    }
  }
};

struct Arguments {
  Settings settings;
  std::vector<std::string> memoryOf;  // surface and contestant
  bool ownFormat = true;
};

/// Takes out what is ours; Google Benchmark gets the rest.
Arguments takeArguments(int& argc, char** argv) {
  Arguments result;
  std::filesystem::path data;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--quick") {
      result.settings = Settings::quick();
    } else if (word == "--data" && i + 1 < argc) {
      data = argv[++i];
    } else if (word == kMemoryOption && i + 2 < argc) {
      result.memoryOf = {argv[i + 1], argv[i + 2]};
      i += 2;
    } else {
      if (word.starts_with("--benchmark_format")) result.ownFormat = false;
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  result.settings.data = data;
  return result;
}

/// Whether nothing of ours was wrong.
bool run(const Settings& settings, bool ownFormat) {
  Report report;
  Tournament tournament(settings, report);
  tournament.enlist();
  const int threads = availableThreads();
  const double coresBefore = coresSeen(threads);
  ProgressReporter progress;
  ownFormat ? benchmark::RunSpecifiedBenchmarks(&progress) : benchmark::RunSpecifiedBenchmarks();
  // Where another format was asked for, it has stdout to itself.
  auto& out = ownFormat ? std::cout : std::cerr;
  printTables(report, out);
  out << "Spin test: " << threads << " threads do the work of " << coresBefore << " before and of "
      << coresSeen(threads) << " after.\n";
  return report.wrongOfOurs() == 0;
}

int runProgram(int argc, char** argv) {
  const auto arguments = takeArguments(argc, argv);
  if (!arguments.memoryOf.empty()) {
    const auto memory =
        memoryOfBuild(arguments.memoryOf[0], arguments.memoryOf[1], arguments.settings);
    std::cout << memory.peak << ' ' << memory.kept << '\n';
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  return run(arguments.settings, arguments.ownFormat) ? 0 : 1;
}

}  // namespace

}  // namespace cutwater::benchmarks

int main(int argc, char** argv) {
  try {
    return cutwater::benchmarks::runProgram(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "cutwater_benchmarks: " << error.what() << '\n';
    return 1;
  }
}
