#pragma once

#include <mpi.h>

#include "Options/Program.hpp"

namespace cutwater::tool {

/// Adds the subcommand `amr`, which runs on all ranks of the communicator.
void addDistributedAmr(Program& program, MPI_Comm comm);

}  // namespace cutwater::tool
