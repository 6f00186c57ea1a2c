#pragma once

#include <cstddef>
#include <mpi.h>
#include <string>

namespace cutwater::tool {

/// What the ranks of a program hold in memory now. Linux only: elsewhere all is 0.
struct ResidentMemory {
  std::size_t together = 0;  ///< bytes; what ranks share counts once
  std::size_t least = 0;     ///< of one rank, for itself alone
  std::size_t most = 0;
};

/// Gives memory back to the system that has been freed, where the allocator keeps some for later.
void returnFreedMemory();

/// Collective; all ranks get the same.
[[nodiscard]] ResidentMemory residentMemory(MPI_Comm comm);

/// "123 MB on all ranks together; 10.1 MB to 12.2 MB on one for itself"
[[nodiscard]] std::string text(const ResidentMemory& memory);

}  // namespace cutwater::tool
