#pragma once

#include <Cutwater/Io/VtkFiles.hpp>
#include <Cutwater/P4est/DistributedOctree.hpp>

namespace cutwater {

/// The file that a rank's piece is in: "hull_03.vtu" beside "hull.pvtu", with as many digits as the
/// last of `size` ranks needs.
[[nodiscard]] std::filesystem::path piecePath(const std::filesystem::path& path, int rank,
                                              int size);

/// Writes a mesh with arrays of one value for each cell of the rank, as writeVtu() does. Every rank
/// writes a piece beside `path`, see piecePath(), and rank 0 the file that joins them. Existing
/// files are replaced once all ranks have written theirs; pieces of an earlier mesh on more ranks
/// remain. Collective.
/// @throws Error, the same on all ranks: as writeVtu().
template <std::floating_point T>
void writePvtu(const std::filesystem::path& path, const DistributedOctree<T>& mesh,
               std::span<const VtkArray> arrays, const VtuOptions& options = {});

extern template void writePvtu(const std::filesystem::path&, const DistributedOctree<float>&,
                               std::span<const VtkArray>, const VtuOptions&);
extern template void writePvtu(const std::filesystem::path&, const DistributedOctree<double>&,
                               std::span<const VtkArray>, const VtuOptions&);

}  // namespace cutwater
