#pragma once

#include <Cutwater/Core/FunctionRef.hpp>

#include <cstdint>
#include <mpi.h>
#include <string>

namespace cutwater {

/// Does the work on every rank. If it throws on any of them, all throw the error of the lowest such
/// rank, of the same kind and with the same text, so that no rank waits for one that has left.
/// Other exceptions are converted to Error. Collective; the work itself must not be.
/// @throws Error as the work does.
void agreed(MPI_Comm comm, FunctionRef<void()> work);

/// Compares what all ranks must have alike, such as the arguments of a collective call, by a
/// checksum of it. Collective.
/// @throws Error(Argument) with the message, on all ranks, unless all have the same.
void requireSame(MPI_Comm comm, std::uint64_t checksum, const std::string& message);

}  // namespace cutwater
