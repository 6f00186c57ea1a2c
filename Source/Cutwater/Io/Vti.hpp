#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Io/VtkXml.hpp>

#include <filesystem>

namespace cutwater {

/// Writes arrays over a patch, one value per index, x fastest, as a VTK image (.vti; XML with the
/// numbers in raw binary behind it), which ParaView and VisIt open: cell data for a level of cells,
/// point data for one of nodes. The image keeps the level's origin and spacing and the patch's
/// indices as its extent. The first array is the one shown first. The file is replaced only once it
/// is complete; the arrays are written from where they are.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the patch or the
/// list of arrays is empty, an array has another length than the patch, names are empty or twice
/// the same, or the patch's outermost index leaves no room for the extent.
template <std::floating_point T>
void writeVti(const std::filesystem::path& path, const Patch<T>& patch,
              std::span<const VtkArray> arrays);

extern template void writeVti(const std::filesystem::path&, const Patch<float>&,
                              std::span<const VtkArray>);
extern template void writeVti(const std::filesystem::path&, const Patch<double>&,
                              std::span<const VtkArray>);

}  // namespace cutwater
