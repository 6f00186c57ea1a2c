#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

// Grids and octrees with arrays, as VTK's XML files.
namespace cutwater {

class OutputFile;

/// A named array of a VTK file: a number or a vector for each cell or node.
struct VtkArray {
  std::string name;
  std::variant<std::span<const float>, std::span<const double>, std::span<const std::int32_t>,
               std::span<const std::uint32_t>, std::span<const std::uint64_t>,
               std::span<const std::uint8_t>, std::span<const Vec3<float>>,
               std::span<const Vec3<double>>>
      values;
};

/// Options of writeVti().
struct VtiOptions {
  /// The names of the surface's patches, see patchNames(), for arrays that hold patches as numbers:
  /// written as field data, an array of texts called "patch names".
  std::vector<std::string> patchNames = {};
};

/// Writes arrays over a grid patch, one value per index, x fastest, as a VTK image (.vti; XML
/// followed by the numbers in raw binary), which ParaView and VisIt open: cell data for a level of
/// cells, point data for a level of nodes. The image keeps the level's origin and spacing, and its
/// extent is the grid patch's indices. The first array is the one that viewers show first. An
/// existing file is replaced only once the new one is complete; the arrays are written without a
/// copy.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the grid
/// patch or the list of arrays is empty, the length of an array differs from the number of indices,
/// names are empty or occur twice, or the extent does not fit because of the outermost index.
template <std::floating_point T>
void writeVti(const std::filesystem::path& path, const GridPatch<T>& gridPatch,
              std::span<const VtkArray> arrays, const VtiOptions& options = {});

extern template void writeVti(const std::filesystem::path&, const GridPatch<float>&,
                              std::span<const VtkArray>, const VtiOptions&);
extern template void writeVti(const std::filesystem::path&, const GridPatch<double>&,
                              std::span<const VtkArray>, const VtiOptions&);

/// Options of writeVtu().
struct VtuOptions {
  /// Write node numbers in 64 bits even where 32 would do, for readers that accept no others.
  bool wideIndices = false;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  /// The names of the surface's patches, see patchNames(), for arrays that hold patches as numbers:
  /// written as field data, an array of texts called "patch names".
  std::vector<std::string> patchNames = {};
};

/// Writes an octree mesh with arrays of one value per cell, in the order of its cells, as a VTK
/// unstructured grid (.vtu; XML followed by the numbers in raw binary), which ParaView and VisIt
/// open. Cells are voxels; those that share a corner share the node, whose coordinates are those of
/// the finest level to the bit. The first array is the one that viewers show first. An existing
/// file is replaced only once the new one is complete. For a part of a mesh, the file is one piece:
/// see writePvtu().
///
/// Takes the memory of OctreeNodes and a few megabytes: the file is written as it is generated, and
/// the arrays without a copy.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the list of
/// arrays is empty, the length of an array differs from the number of cells, or names are empty or
/// occur twice.
template <std::floating_point T>
void writeVtu(const std::filesystem::path& path, const OctreeCells<T>& mesh,
              std::span<const VtkArray> arrays, const VtuOptions& options = {});

namespace detail {

/// Writes the same into a file that the caller commits.
template <std::floating_point T>
void writeVtu(OutputFile& file, const OctreeCells<T>& mesh, std::span<const VtkArray> arrays,
              const VtuOptions& options);

}  // namespace detail

extern template void writeVtu(const std::filesystem::path&, const OctreeCells<float>&,
                              std::span<const VtkArray>, const VtuOptions&);
extern template void writeVtu(const std::filesystem::path&, const OctreeCells<double>&,
                              std::span<const VtkArray>, const VtuOptions&);

/// Writes a VTK parallel unstructured grid (.pvtu), which joins .vtu files, each a piece of one
/// mesh, so that ParaView opens them together. `pieces` are names relative to its folder. Names and
/// types of the arrays must be those in every piece, and T the type of its points; values are not
/// used. An existing file is replaced only once the new one is complete.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if there are no
/// pieces, the list of arrays is empty, or names are empty or occur twice.
template <std::floating_point T>
void writePvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
               std::span<const VtkArray> arrays);

extern template void writePvtu<float>(const std::filesystem::path&, std::span<const std::string>,
                                      std::span<const VtkArray>);
extern template void writePvtu<double>(const std::filesystem::path&, std::span<const std::string>,
                                       std::span<const VtkArray>);

}  // namespace cutwater
