#pragma once

#include "Report.hpp"
#include "Settings.hpp"

namespace cutwater::benchmarks {

/// Builds in this process, which should have done nothing else before.
[[nodiscard]] Memory memoryOfBuild(const std::string& surface, const std::string& contestant,
                                   const Settings& settings);

/// The same in a process of its own: runs this program with the option that main() understands.
[[nodiscard]] Memory memoryInChild(const std::string& surface, const std::string& contestant,
                                   const Settings& settings);

inline constexpr const char* kMemoryOption = "--memory-of-build";

}  // namespace cutwater::benchmarks
