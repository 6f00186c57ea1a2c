#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cutwater::benchmarks {

inline constexpr const char* kOurs = "Cutwater";

/// One contestant in one workload.
struct Race {
  std::string surface;
  int threads = 1;
  std::string workload;
  std::string contestant;
  auto operator<=>(const Race&) const = default;
};

/// The best of all rounds.
struct Time {
  double nanoseconds = std::numeric_limits<double>::infinity();  ///< per query
  double share = 1;    ///< of the workload's points that were asked for
  double queries = 0;  ///< of all of them

  /// For all of them.
  [[nodiscard]] double seconds() const { return 1e-9 * nanoseconds * queries; }
};

/// Answers held against others.
struct Check {
  std::string surface;
  std::string workload;
  std::string contestant;
  std::string truth;  ///< whose answers it was held against
  std::size_t answers = 0;
  std::size_t wrongValues = 0;
  std::size_t wrongSigns = 0;
  double largestError = 0;  ///< over the diagonal of the surface's box
};

/// Parts of a tree.
struct Openings {
  std::size_t nodes = 0;
  std::size_t leaves = 0;
};

/// What all queries of a workload together look at.
struct Effort {
  std::size_t queries = 0;
  Openings opened;
  Openings necessary;         ///< those that no search through the tree can leave out
  std::size_t evaluated = 0;  ///< triangles, in full

  [[nodiscard]] double perQuery(std::size_t count) const {
    return static_cast<double>(count) / static_cast<double>(queries);
  }
};

struct Memory {
  std::size_t peak = 0;  ///< bytes in use at most while it was built, beside the soup
  std::size_t kept = 0;  ///< bytes in use after, as the system sees them
};

struct SurfaceFacts {
  std::size_t triangles = 0;
  std::size_t memoryBytes = 0;  ///< MeshSDF::memoryBytes()
  std::string signs;
  double leafNanoseconds = 0;  ///< to fetch what a leaf holds, see leafFetchNanoseconds()
  double writingSeconds = 0;   ///< to write one value to all cells of the band's grid
};

/// Everything that was found out; the tables are made of it.
struct Report {
  std::map<Race, Time> times;
  std::vector<Check> checks;
  std::map<std::pair<std::string, std::string>, Memory> memory;  ///< by surface and contestant
  std::map<std::string, SurfaceFacts> surfaces;
  std::map<std::pair<std::string, std::string>, Effort> efforts;  ///< ours, by surface and workload

  void add(const Race& race, const Time& time);
  [[nodiscard]] const Time* find(const Race& race) const;
  /// Null for others than ours, and where nothing is counted.
  [[nodiscard]] const Effort* findEffort(const Race& race) const;
  /// Answers of ours that were wrong.
  [[nodiscard]] std::size_t wrongOfOurs() const;
};

}  // namespace cutwater::benchmarks
