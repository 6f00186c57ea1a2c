#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Io/VtkArray.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace cutwater {

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

}  // namespace cutwater
