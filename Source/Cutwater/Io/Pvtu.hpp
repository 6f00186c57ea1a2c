#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Io/VtkArray.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace cutwater {

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
