#pragma once

#include <mpi.h>

namespace CLI {
class App;
}

namespace cutwater::tool {

/// Adds the subcommand `amr`, which runs on all ranks of the communicator.
void addDistributedAmr(CLI::App& program, MPI_Comm comm);

}  // namespace cutwater::tool
