#include "Memory.hpp"

#include <cstdint>
#include <fstream>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

struct Own {
  std::uint64_t share = 0;         ///< pages of n processes count 1/n
  std::uint64_t privateBytes = 0;  ///< of this one alone
};

Own ownMemory() {
  constexpr std::uint64_t kUnit = 1024;
  Own result;
  std::ifstream file("/proc/self/smaps_rollup");
  file.ignore(1 << 12, '\n');  // a range of addresses
  std::string name;
  std::uint64_t size = 0;
  std::string unit;
  while (file >> name >> size >> unit) {
    if (name == "Pss:") result.share = kUnit * size;
    if (name == "Private_Clean:" || name == "Private_Dirty:") result.privateBytes += kUnit * size;
  }
  return result;
}

std::uint64_t reduced(std::uint64_t own, MPI_Op operation, MPI_Comm comm) {
  std::uint64_t result = 0;
  MPI_Allreduce(&own, &result, 1, MPI_UINT64_T, operation, comm);
  return result;
}

}  // namespace

void returnFreedMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

ResidentMemory residentMemory(MPI_Comm comm) {
  MPI_Barrier(comm);  // all hold what they hold
  const auto own = ownMemory();
  return {reduced(own.share, MPI_SUM, comm), reduced(own.privateBytes, MPI_MIN, comm),
          reduced(own.privateBytes, MPI_MAX, comm)};
}

std::string text(const ResidentMemory& memory) {
  return bytes(memory.together) + " on all ranks together; " + bytes(memory.least) + " to " +
         bytes(memory.most) + " on one for itself";
}

}  // namespace cutwater::tool
