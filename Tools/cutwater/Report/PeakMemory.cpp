#include "Report/PeakMemory.hpp"

#include <sys/resource.h>

namespace cutwater::tool {

std::optional<std::size_t> peakResidentBytes() {
#ifdef __APPLE__
  constexpr std::size_t kUnit = 1;
#else
  constexpr std::size_t kUnit = 1024;
#endif
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0 || usage.ru_maxrss <= 0) return {};
  return kUnit * static_cast<std::size_t>(usage.ru_maxrss);
}

}  // namespace cutwater::tool
