#pragma once

#include <Cutwater/Core/Level.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <variant>

namespace cutwater {

/// One named value per index of a patch, x fastest.
struct VtiArray {
  std::string name;
  std::variant<std::span<const float>, std::span<const double>, std::span<const std::uint32_t>>
      values;
};

/// Writes arrays over a patch as a VTK image (.vti; XML with the numbers in raw binary behind it),
/// which ParaView and VisIt open: cell data for a level of cells, point data for one of nodes. The
/// image keeps the level's origin and spacing and the patch's indices as its extent. The first
/// array is the one shown first. The file is replaced only once it is complete; the arrays are
/// written from where they are.
/// @throws Error(File) naming the path if it cannot be written; Error(Argument) if the patch or the
/// list of arrays is empty, an array has another length than the patch, names are empty or twice
/// the same, or the patch's outermost index leaves no room for the extent.
template <std::floating_point T>
void writeVti(const std::filesystem::path& path, const Patch<T>& patch,
              std::span<const VtiArray> arrays);

extern template void writeVti(const std::filesystem::path&, const Patch<float>&,
                              std::span<const VtiArray>);
extern template void writeVti(const std::filesystem::path&, const Patch<double>&,
                              std::span<const VtiArray>);

}  // namespace cutwater
