#include "Options/MachineMemory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace cutwater::tool {

namespace {

namespace fs = std::filesystem;

constexpr auto kNoLimit = std::numeric_limits<std::size_t>::max();

/// The number in a file such as memory.max; none in "max", or if it cannot be read.
std::size_t limitIn(const fs::path& file) {
  std::ifstream stream(file);
  std::size_t limit = 0;
  return stream >> limit ? limit : kNoLimit;
}

/// The least limit of a control group and of those around it, up to `root`.
std::size_t limitOfGroup(const fs::path& root, const std::string& group, const char* file) {
  std::size_t least = limitIn(root / file);
  fs::path folder = root;
  for (const auto& name : fs::path(group).relative_path()) {
    folder /= name;
    least = std::min(least, limitIn(folder / file));
  }
  return least;
}

/// Of the control groups that /proc/self/cgroup lists, "0::/user.slice" (version 2, all resources)
/// or "7:memory:/user.slice" (version 1). In a container, a group's own folder may be the root.
std::size_t limitOfGroups() {
  const fs::path root = "/sys/fs/cgroup";
  auto least =
      std::min(limitIn(root / "memory.max"), limitIn(root / "memory/memory.limit_in_bytes"));
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const auto resources = "," + line.substr(first + 1, second - first - 1) + ",";
    const auto group = line.substr(second + 1);
    if (resources == ",,") {
      least = std::min(least, limitOfGroup(root, group, "memory.max"));
    } else if (resources.find(",memory,") != std::string::npos) {
      least = std::min(least, limitOfGroup(root / "memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

std::size_t limitOfAddresses() {
  rlimit limit{};
  const bool isSet = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return isSet ? static_cast<std::size_t>(limit.rlim_cur) : kNoLimit;
}

}  // namespace

std::size_t memoryOfMachine() {
  const auto pages = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES));
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return std::min({pages * page, limitOfGroups(), limitOfAddresses()});
}

}  // namespace cutwater::tool
