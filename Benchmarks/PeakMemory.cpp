#include "PeakMemory.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <malloc.h>

#include "Arena.hpp"
#include "Meshes.hpp"

namespace cutwater::benchmarks {

namespace {

/// A line of /proc/self/status, in bytes; 0 where there is none.
std::size_t statusBytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::size_t kilobytes = 0;
    if (word == key + ":" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

Memory memoryOfBuild(const std::string& surface, const std::string& contestant,
                     const Settings& settings) {
  const auto soup = loadSurface(surface, settings.data);
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << '5';  // the peak starts here
  const auto before = statusBytes("VmRSS");
  std::optional<MeshSDF<double>> ours;
  std::unique_ptr<Peer> other;
  if (contestant == kOurs) ours.emplace(soup);
  for (const auto& kind : peers()) {
    if (kind.name == contestant) other = kind.build(soup, availableThreads());
  }
  const auto peak = statusBytes("VmHWM") - before;
  malloc_trim(0);
  return {.peak = peak, .kept = statusBytes("VmRSS") - before};
}

Memory memoryInChild(const std::string& surface, const std::string& contestant,
                     const Settings& settings) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  std::string command = "'";
  command += program.string() + "' --data '" + settings.data.string() + "' " + kMemoryOption + " " +
             surface + " " + contestant;
  auto* const child = popen(command.c_str(), "r");
  if (child == nullptr) return {};
  Memory memory;
  if (std::fscanf(child, "%zu %zu", &memory.peak, &memory.kept) != 2) memory = {};
  pclose(child);
  return memory;
}

}  // namespace cutwater::benchmarks
