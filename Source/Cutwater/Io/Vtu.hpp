#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Io/VtkXml.hpp>

#include <filesystem>

namespace cutwater {

/// Options of writeVtu().
struct VtuOptions {
  /// Numbers of nodes in 64 bits even where 32 do, for readers that know no others.
  bool wideIndices = false;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
};

/// Writes an octree mesh with arrays of one value per cell, in the order of its cells, as a VTK
/// unstructured grid (.vtu; XML with the numbers in raw binary behind it), which ParaView and VisIt
/// open. Cells are voxels; those that share a corner share the node, whose coordinates are those of
/// the finest level to the bit. The first array is the one shown first. The file is replaced only
/// once it is complete. Of a stretch of a mesh it is one piece: see writePvtu().
///
/// Takes the memory of OctreeNodes and a few megabytes: the file is written as it is made, and the
/// arrays from where they are.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the list of
/// arrays is empty, an array has another length than the list of cells, or names are empty or twice
/// the same.
template <std::floating_point T>
void writeVtu(const std::filesystem::path& path, const OctreeCells<T>& mesh,
              std::span<const VtkArray> arrays, const VtuOptions& options = {});

namespace detail {

/// The same into a file that the caller commits.
template <std::floating_point T>
void writeVtu(OutputFile& file, const OctreeCells<T>& mesh, std::span<const VtkArray> arrays,
              const VtuOptions& options);

}  // namespace detail

extern template void writeVtu(const std::filesystem::path&, const OctreeCells<float>&,
                              std::span<const VtkArray>, const VtuOptions&);
extern template void writeVtu(const std::filesystem::path&, const OctreeCells<double>&,
                              std::span<const VtkArray>, const VtuOptions&);

}  // namespace cutwater
