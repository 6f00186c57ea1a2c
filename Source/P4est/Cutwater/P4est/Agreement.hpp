#pragma once

#include <Cutwater/Core/FunctionRef.hpp>

#include <mpi.h>

namespace cutwater {

/// Does the work on every rank. If it throws on any of them, all throw the error of the lowest such
/// rank, of the same kind and with the same text, so that no rank waits for one that has left.
/// Other exceptions are converted to Error. Collective; the work itself must not be.
/// @throws Error as the work does.
void agreed(MPI_Comm comm, FunctionRef<void()> work);

}  // namespace cutwater
