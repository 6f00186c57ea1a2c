#pragma once

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Io/VtkXml.hpp>

#include <filesystem>

namespace cutwater {

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
/// once it is complete.
///
/// Takes the memory of OctreeNodes and a few megabytes: the file is written as it is made, and the
/// arrays from where they are.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the list of
/// arrays is empty, an array has another length than the list of cells, or names are empty or twice
/// the same.
template <std::floating_point T>
void writeVtu(const std::filesystem::path& path, const Octree<T>& mesh,
              std::span<const VtkArray> arrays, const VtuOptions& options = {});

extern template void writeVtu(const std::filesystem::path&, const Octree<float>&,
                              std::span<const VtkArray>, const VtuOptions&);
extern template void writeVtu(const std::filesystem::path&, const Octree<double>&,
                              std::span<const VtkArray>, const VtuOptions&);

}  // namespace cutwater
